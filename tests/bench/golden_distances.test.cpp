// SPDX-License-Identifier: MIT
#include "bench/golden_check.hpp"
#include "bench/pairs.hpp"

using namespace detent::bench;

TEST_CASE("golden: distances of two shapes have their hit counts") {
  visit_round_distances(check_golden);
  visit_flat_distances(check_golden);
}
TEST_CASE("golden: closest points of two shapes have their hit counts") {
  visit_round_closest_points(check_golden);
  visit_flat_closest_points(check_golden);
  visit_hull_closest_points(check_golden);
}
