// SPDX-License-Identifier: MIT
#include "bench/golden_check.hpp"
#include "bench/queries.hpp"

using namespace detent::bench;

TEST_CASE("golden: raycasts have their hit counts") {
  visit_raycasts(check_golden);
  visit_raycast_hits(check_golden);
}
TEST_CASE("golden: contains queries have their hit counts") { visit_contains(check_golden); }
TEST_CASE("golden: closest points have their hit counts") { visit_closest_points(check_golden); }
TEST_CASE("golden: distances of points have their hit counts") { visit_distances(check_golden); }
TEST_CASE("golden: overlaps have their hit counts") {
  visit_sphere_overlaps(check_golden);
  visit_box_overlaps(check_golden);
  visit_other_overlaps(check_golden);
}
TEST_CASE("golden: segments have their hit counts") { visit_intersects(check_golden); }
TEST_CASE("golden: hulls have their hit counts") { visit_hulls(check_golden); }
TEST_CASE("golden: 2D shapes have their hit counts") { visit_planar(check_golden); }
TEST_CASE("golden: cameras have their hit counts") { visit_cameras(check_golden); }
