// SPDX-License-Identifier: MIT
#include "bench/golden_check.hpp"
#include "bench/pairs.hpp"

using namespace detent::bench;

TEST_CASE("golden: casts of hulls have their hit counts") { visit_casts<MovingRock>(check_golden); }
