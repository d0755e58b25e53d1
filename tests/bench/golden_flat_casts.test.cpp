// SPDX-License-Identifier: MIT
#include "bench/golden_check.hpp"
#include "bench/pairs.hpp"

using namespace detent::bench;

TEST_CASE("golden: casts of boxes, triangles and hulls have their hit counts") {
  visit_aabb_casts(check_golden);
  visit_obb_casts(check_golden);
  visit_triangle_casts(check_golden);
  visit_hull_casts(check_golden);
}
