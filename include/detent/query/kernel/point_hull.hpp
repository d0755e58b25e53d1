// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "detent/query/kernel/gjk.hpp"

namespace detent::detail {

/// The hull of one point.
template <Scalar S, int N>
[[nodiscard]] constexpr ConvexHull<S, N> hull_of(const Vec<S, N>& point) noexcept {
  return {std::span<const Vec<S, N>>(&point, 1)};
}

/// Whether `point` is in `hull`.
template <Scalar S, int N>
[[nodiscard]] constexpr bool holds(const ConvexHull<S, N>& hull, const Vec<S, N>& point) noexcept {
  return !is_empty(hull) && bodies_overlap(HullBody(hull), HullBody(hull_of(point)));
}

/// The squared distance from `point` to `hull`, which must not be empty.
template <Scalar S, int N>
[[nodiscard]] constexpr auto squared_distance_from_hull(const ConvexHull<S, N>& hull,
                                                        const Vec<S, N>& point) noexcept {
  return squared_distance_between(HullBody(hull), HullBody(hull_of(point)));
}

/// Whether `point` is within `reach` >= 0 of `hull`.
template <Scalar S, int N>
[[nodiscard]] constexpr bool within_reach(const ConvexHull<S, N>& hull, const Vec<S, N>& point,
                                          const S& reach) noexcept {
  return !is_empty(hull) && squared_distance_from_hull(hull, point) <= square(reach);
}

}  // namespace detent::detail
