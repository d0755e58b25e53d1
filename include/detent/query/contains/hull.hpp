// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/gjk.hpp"

namespace detent {

namespace detail {

/// The hull of one point.
template <Scalar S, int N>
[[nodiscard]] constexpr ConvexHull<S, N> hull_of(const Vec<S, N>& point) noexcept {
  return {std::span<const Vec<S, N>>(&point, 1)};
}

}  // namespace detail

/// Whether `point` is in `hull`, its faces, edges and corners included.
///
/// domain: every input; a flat hull is the polygon, segment or point that its points span; one
///         without points is empty
/// exact:  yes or no exact                                      (tests/oracle/point_hull.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool contains(const ConvexHull<S, N>& hull,
                                      const Vec<S, N>& point) noexcept {
  if (is_empty(hull)) return false;
  return detail::bodies_overlap(detail::HullBody(hull), detail::HullBody(detail::hull_of(point)));
}

}  // namespace detent
