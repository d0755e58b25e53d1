// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/point_hull.hpp"
#include "detent/shape/sphere.hpp"

namespace detent {

/// Whether `sphere` and `hull` share a point.
///
/// domain: every input; an empty sphere or hull overlaps nothing
/// exact:  yes or no exact; touching counts              (tests/oracle/hull_round_pairs.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Sphere<S, N>& sphere,
                                      const ConvexHull<S, N>& hull) noexcept {
  return sphere.radius >= 0 && detail::within_reach(hull, sphere.center, sphere.radius);
}
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const ConvexHull<S, N>& hull,
                                      const Sphere<S, N>& sphere) noexcept {
  return overlaps(sphere, hull);
}

}  // namespace detent
