// SPDX-License-Identifier: MIT
#include "bench/golden_check.hpp"
#include "bench/pairs.hpp"

using namespace detent::bench;

TEST_CASE("golden: casts of capsules have their hit counts") {
  visit_casts<MovingCapsule>(check_golden);
}
