// SPDX-License-Identifier: MIT
#include "oracle/closest_points_exam.hpp"

namespace detent::oracle {
namespace {

TEST_CASE("closest points in 2D: every coordinate is the exact one rounded once", "[oracle]") {
  examine_polytope_points<q16_16, 2>(0xc107, 60);
  examine_round_points<q16_16, 2>(0xc108, 60);
}

}  // namespace
}  // namespace detent::oracle
