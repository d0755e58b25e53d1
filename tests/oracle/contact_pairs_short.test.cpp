// SPDX-License-Identifier: MIT
#include "oracle/contact_exam.hpp"

namespace detent::oracle {
namespace {

TEMPLATE_TEST_CASE(
    "contact, short scalars: depth and normal of every two shapes are the exact ones", "[oracle]",
    (test::Space<q14_16, 3>), (test::Space<q14_16, 2>), (test::Space<q8_8, 3>),
    (test::Space<q8_8, 2>)) {
  examine_contacts<typename TestType::scalar, TestType::dimension>(0xc0117ac7, 60);
}

TEMPLATE_TEST_CASE("contact, short scalars: depth and normal of many more pairs are exact",
                   "[oracle][.demand]", (test::Space<q14_16, 3>), (test::Space<q14_16, 2>),
                   (test::Space<q8_8, 3>), (test::Space<q8_8, 2>)) {
  for (const auto seed : demanded_seeds()) {
    examine_contacts<typename TestType::scalar, TestType::dimension>(seed, 300);
  }
}

}  // namespace
}  // namespace detent::oracle
