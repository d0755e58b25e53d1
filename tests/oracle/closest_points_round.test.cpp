// SPDX-License-Identifier: MIT
#include "oracle/closest_points_exam.hpp"

namespace detent::oracle {
namespace {

TEMPLATE_TEST_CASE("closest points of round shapes: every coordinate is the exact one rounded once",
                   "[oracle]", (test::Space<q16_16, 3>)) {
  examine_round_points<typename TestType::scalar, TestType::dimension>(0xc106, 60);
}

}  // namespace
}  // namespace detent::oracle
