// SPDX-License-Identifier: MIT
#include "oracle/impact_exam.hpp"

namespace detent::oracle {
namespace {

TEMPLATE_TEST_CASE("time of impact, 31 bits: apart before it, and as close as stated at it",
                   "[oracle]", (test::Space<q16_16, 2>), (test::Space<q24_8, 3>),
                   (test::Space<q24_8, 2>)) {
  examine_impacts<typename TestType::scalar, TestType::dimension>(0x701, 40);
}

TEMPLATE_TEST_CASE("time of impact, 31 bits: many more", "[oracle][.demand]",
                   (test::Space<q16_16, 2>), (test::Space<q24_8, 3>), (test::Space<q24_8, 2>)) {
  for (const auto seed : demanded_seeds()) {
    examine_impacts<typename TestType::scalar, TestType::dimension>(seed, 500);
  }
}

}  // namespace
}  // namespace detent::oracle
