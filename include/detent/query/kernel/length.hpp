// SPDX-License-Identifier: MIT
#pragma once

#include "detent/number/rounding.hpp"

namespace detent::detail {

/// Holds the distance between two points of the range, which is below 2 sqrt(3) times the greatest
/// coordinate.
template <Scalar S>
using Length = decltype(S() + S() + S());

/// The distance to a round shape, 0 inside, from the distance to its core. The radius is on the
/// grid, so it may be subtracted after that distance is rounded down.
template <Scalar S, Number Radius>
[[nodiscard]] constexpr S less_radius(const Length<S>& to_core, const Radius& radius) noexcept {
  const auto beyond = to_core - radius;
  return beyond > 0 ? floor_to<S>(beyond) : S(0);
}

}  // namespace detent::detail
