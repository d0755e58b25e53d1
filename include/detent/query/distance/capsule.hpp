// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/point_capsule.hpp"
#include "detent/query/kernel/point_segment.hpp"

namespace detent {

/// The distance from `point` to `capsule`, 0 inside.
///
/// units:  world units
/// domain: every input; clamped to the greatest scalar, which is the result for an empty capsule
/// exact:  rounded down, error in [0, 1) ULP                 (tests/oracle/point_capsule.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr S distance(const Capsule<S, N>& capsule, const Vec<S, N>& point) noexcept {
  if (capsule.radius < 0) return largest<S>;
  if constexpr (!is_fixed<S>) {
    if (detail::holds(capsule, point)) return S(0);
  }
  // The radius is on the grid, so it may be subtracted after the distance to the axis is rounded.
  // That distance is below 2 sqrt(3) times the greatest coordinate. Inside, the difference is at
  // most 0.
  using Length = decltype(S() + S() + S());
  const auto to_axis = detail::distance_to<Length>(Segment{capsule.a, capsule.b}, point);
  const auto beyond = to_axis - capsule.radius;
  return beyond > 0 ? floor_to<S>(beyond) : S(0);
}

}  // namespace detent
