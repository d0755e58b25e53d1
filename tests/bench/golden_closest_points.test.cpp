// SPDX-License-Identifier: MIT
#include "bench/golden_check.hpp"
#include "bench/still_pairs.hpp"

using namespace detent::bench;

TEST_CASE("golden: closest points of two shapes in 3D have their hit counts") {
  visit_pairs<PairQuery::closest_points, 3>(check_golden);
}
TEST_CASE("golden: closest points of two shapes in 2D have their hit counts") {
  visit_pairs<PairQuery::closest_points, 2>(check_golden);
}
