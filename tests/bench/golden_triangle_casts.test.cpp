// SPDX-License-Identifier: MIT
#include "bench/golden_check.hpp"
#include "bench/pairs.hpp"

using namespace detent::bench;

TEST_CASE("golden: casts of triangles have their hit counts") {
  visit_casts<MovingTriangle>(check_golden);
}
