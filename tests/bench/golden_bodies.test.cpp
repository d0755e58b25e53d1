// SPDX-License-Identifier: MIT
#include "bench/bodies.hpp"
#include "bench/golden_check.hpp"

using namespace detent::bench;

TEST_CASE("golden: moving bodies and shapes at a mesh have their hit counts") {
  visit_bodies(check_golden);
}
