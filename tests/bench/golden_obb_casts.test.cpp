// SPDX-License-Identifier: MIT
#include "bench/golden_check.hpp"
#include "bench/pairs.hpp"

using namespace detent::bench;

TEST_CASE("golden: casts of OBBs have their hit counts") { visit_casts<MovingObb>(check_golden); }
