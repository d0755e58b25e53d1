// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/gjk.hpp"
#include "detent/shape/capsule.hpp"

namespace detent {

/// Whether `capsule` and `hull` share a point.
///
/// domain: every input; an empty capsule or hull overlaps nothing
/// exact:  yes or no exact; touching counts              (tests/oracle/hull_round_pairs.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Capsule<S, N>& capsule,
                                      const ConvexHull<S, N>& hull) noexcept {
  if (capsule.radius < 0 || is_empty(hull)) return false;
  const std::array ends{capsule.a, capsule.b};
  return detail::squared_distance_between(detail::HullBody(ConvexHull{ends}),
                                          detail::HullBody(hull)) <=
         capsule.radius * capsule.radius;
}
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const ConvexHull<S, N>& hull,
                                      const Capsule<S, N>& capsule) noexcept {
  return overlaps(capsule, hull);
}

}  // namespace detent
