// SPDX-License-Identifier: MIT
#include "oracle/distance_exam.hpp"

namespace detent::oracle {
namespace {

TEMPLATE_TEST_CASE("distance of two shapes, q24_8: every answer is the exact one rounded down",
                   "[oracle]", (test::Space<q24_8, 3>), (test::Space<q24_8, 2>)) {
  examine_distances<typename TestType::scalar, TestType::dimension>(0xd157, 60);
}

TEMPLATE_TEST_CASE("distance of two shapes, q24_8: many more answers are exact",
                   "[oracle][.demand]", (test::Space<q24_8, 3>), (test::Space<q24_8, 2>)) {
  for (const auto seed : demanded_seeds()) {
    examine_distances<typename TestType::scalar, TestType::dimension>(seed, 1000);
  }
}

}  // namespace
}  // namespace detent::oracle
