// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/convex_body.hpp"
#include "detent/query/kernel/gjk.hpp"

namespace detent {

/// Whether `box` and `hull` share a point.
///
/// domain: every input; an empty box or hull overlaps nothing
/// exact:  yes or no exact; touching counts                       (tests/oracle/aabb_hull.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Aabb<S, N>& box,
                                      const ConvexHull<S, N>& hull) noexcept {
  if (is_empty(box) || is_empty(hull)) return false;
  return detail::bodies_overlap(detail::AabbBody(box), detail::HullBody(hull));
}
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const ConvexHull<S, N>& hull,
                                      const Aabb<S, N>& box) noexcept {
  return overlaps(box, hull);
}

}  // namespace detent
