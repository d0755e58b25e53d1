// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "detent/math/rotation.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace detent::test {

/// A rotation of less than 2^(bits - 32) turns about each world axis.
template <Scalar S>
Rotation<S, 3> random_turn(Random& random, int bits) {
  const auto angle = [&] {
    return Angle<S>::from_raw(static_cast<std::uint32_t>(random.wide(bits)));
  };
  const auto x = angle(), y = angle();
  return Rotation<S, 3>::from_euler(x, y, angle());
}

/// Calls compare(random) `asked` times, with random numbers of their own for each `bits`.
template <class Compare>
void repeat(int bits, int asked, const Compare& compare) {
  Random random(static_cast<std::uint64_t>(bits));
  INFO(random);
  for (int i = 0; i < asked; ++i) {
    CAPTURE(bits, i);
    compare(random);
  }
}

}  // namespace detent::test
