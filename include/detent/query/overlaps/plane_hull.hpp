// SPDX-License-Identifier: MIT
#pragma once

#include "detent/shape/hull.hpp"
#include "detent/shape/plane.hpp"

namespace detent {

/// Whether `plane` and `hull` share a point: not all points are strictly on the same side.
///
/// domain: every input; an empty hull overlaps nothing
/// exact:  yes or no exact; touching counts              (tests/oracle/hull_round_pairs.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Plane<S, N>& plane,
                                      const ConvexHull<S, N>& hull) noexcept {
  bool reaches_below = false, reaches_above = false;
  for (const auto& point : hull.points) {
    const auto along = dot(plane.normal, point);
    reaches_below = reaches_below || along <= plane.offset;
    reaches_above = reaches_above || along >= plane.offset;
    if (reaches_below && reaches_above) return true;
  }
  return false;
}
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const ConvexHull<S, N>& hull,
                                      const Plane<S, N>& plane) noexcept {
  return overlaps(plane, hull);
}

}  // namespace detent
