// SPDX-License-Identifier: MIT
#include "bench/golden_check.hpp"
#include "bench/pairs.hpp"

using namespace detent::bench;

TEST_CASE("golden: casts of spheres, capsules and segments have their hit counts") {
  visit_sphere_casts(check_golden);
  visit_capsule_casts(check_golden);
  visit_segment_casts(check_golden);
}
