// SPDX-License-Identifier: MIT
#include "oracle/contact_exam.hpp"

namespace detent::oracle {
namespace {

TEMPLATE_TEST_CASE("contact, q24_8: depth and normal of every two shapes are the exact ones",
                   "[oracle]", (test::Space<q24_8, 3>), (test::Space<q24_8, 2>)) {
  examine_contacts<typename TestType::scalar, TestType::dimension>(0xc0117ac7, 60);
}

TEMPLATE_TEST_CASE("contact, q24_8: depth and normal of many more pairs are exact",
                   "[oracle][.demand]", (test::Space<q24_8, 3>), (test::Space<q24_8, 2>)) {
  for (const auto seed : demanded_seeds()) {
    examine_contacts<typename TestType::scalar, TestType::dimension>(seed, 300);
  }
}

}  // namespace
}  // namespace detent::oracle
