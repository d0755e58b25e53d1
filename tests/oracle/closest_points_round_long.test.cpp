// SPDX-License-Identifier: MIT
#include "oracle/closest_points_exam.hpp"

namespace detent::oracle {
namespace {

TEMPLATE_TEST_CASE("closest points of round shapes, q24_8: every coordinate is rounded once",
                   "[oracle]", (test::Space<q24_8, 3>)) {
  examine_round_points<typename TestType::scalar, TestType::dimension>(0xc10c, 60);
}

}  // namespace
}  // namespace detent::oracle
