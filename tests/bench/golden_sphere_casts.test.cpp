// SPDX-License-Identifier: MIT
#include "bench/golden_check.hpp"
#include "bench/pairs.hpp"

using namespace detent::bench;

TEST_CASE("golden: casts of spheres have their hit counts") {
  visit_casts<MovingSphere>(check_golden);
}
