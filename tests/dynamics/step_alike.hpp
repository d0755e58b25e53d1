// SPDX-License-Identifier: MIT
#pragma once

#include "detent/number/digest.hpp"
#include "support/catch.hpp"

namespace detent::test {

/// Steps both worlds `ticks` times; they must be equal before and after each step.
template <class World>
void step_alike(World& a, World& b, int ticks) {
  for (int t = 0; t < ticks; ++t) {
    CAPTURE(t);
    REQUIRE(digest(a) == digest(b));
    a.step();
    b.step();
  }
  REQUIRE(digest(a) == digest(b));
}

}  // namespace detent::test
