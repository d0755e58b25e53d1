// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/point_plane.hpp"
#include "detent/shape/capsule.hpp"

namespace detent {

/// Whether `plane` and `capsule` share a point: the ends lie on opposite sides, or one of them is
/// within the radius.
///
/// domain: every input; a negative radius is an empty capsule and overlaps nothing
/// exact:  yes or no exact; touching counts                 (tests/oracle/capsule_pairs.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Plane<S, N>& plane,
                                      const Capsule<S, N>& capsule) noexcept {
  if (capsule.radius < 0) return false;
  const auto a = detail::height_above(plane, capsule.a), b = detail::height_above(plane, capsule.b);
  if ((a < 0 && b > 0) || (a > 0 && b < 0)) return true;
  return detail::within_reach(plane, capsule.a, capsule.radius) ||
         detail::within_reach(plane, capsule.b, capsule.radius);
}
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Capsule<S, N>& capsule,
                                      const Plane<S, N>& plane) noexcept {
  return overlaps(plane, capsule);
}

}  // namespace detent
