// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/box.hpp"
#include "detent/query/kernel/box_filter.hpp"
#include "detent/query/kernel/separation.hpp"
#include "detent/shape/aabb.hpp"
#include "detent/shape/obb.hpp"

namespace detent {

/// Whether two boxes share a point, surfaces included.
///
/// The oriented box is the one that its edges span: center + sum of s[i] half_extents[i] axis(i)
/// with |s[i]| <= 1.
///
/// domain: every input; a box with min > max on some axis or a negative half extent is empty and
///         overlaps nothing
/// exact:  yes or no exact                                        (tests/oracle/aabb_obb.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Aabb<S, N>& a, const Obb<S, N>& b) noexcept {
  if (is_empty(a) || is_empty(b)) return false;
  // Doubled, so that both centers are on the grid.
  const auto half_a = a.max - a.min;
  const auto half_b = b.half_extents + b.half_extents;
  const auto apart = b.center + b.center - (a.min + a.max);
  const auto exact = [&] {
    if constexpr (N == 2) {
      return !detail::are_apart(std::array{apart}, detail::edges_along(Rotation<S, N>(), half_a),
                                detail::edges_along(b.rotation, half_b));
    } else {
      return detail::boxes_overlap(detail::WorldFrame(), half_a, detail::EdgeFrame<S>(b.rotation),
                                   half_b, apart);
    }
  };
  if constexpr (filter_pays<S>) {
    return or_exact(detail::decide_boxes_overlap(a, b), exact);
  } else {
    return exact();
  }
}

template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Obb<S, N>& b, const Aabb<S, N>& a) noexcept {
  return overlaps(a, b);
}

}  // namespace detent
