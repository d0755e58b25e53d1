// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/box.hpp"
#include "detent/query/kernel/box_filter.hpp"
#include "detent/query/kernel/separation.hpp"
#include "detent/shape/obb.hpp"

namespace detent {

/// Whether two boxes share a point, surfaces included.
///
/// Each box is the one that its edges span: center + sum of s[i] half_extents[i] axis(i) with
/// |s[i]| <= 1.
///
/// domain: every input; a box with a negative half extent is empty and overlaps nothing
/// exact:  yes or no exact                                         (tests/oracle/obb_obb.test.cpp)
/// source: Ericson, Real-Time Collision Detection, 4.4.1
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Obb<S, N>& a, const Obb<S, N>& b) noexcept {
  if (is_empty(a) || is_empty(b)) return false;
  const auto apart = b.center - a.center;
  const auto exact = [&] {
    if constexpr (N == 3) {
      const detail::EdgeFrame<S> frame_a(a.rotation), frame_b(b.rotation);
      if (!frame_a.is_flat() || !frame_b.is_flat()) {
        return detail::boxes_overlap(frame_a, a.half_extents, frame_b, b.half_extents, apart);
      }
    }
    // The stored axes may all lie in one plane. Together with the world's own they span space.
    return !detail::are_apart(std::array{apart}, detail::edges_along(Rotation<S, N>(), Vec<S, N>()),
                              detail::edges_along(a.rotation, a.half_extents),
                              detail::edges_along(b.rotation, b.half_extents));
  };
  if constexpr (filter_pays<S>) {
    return or_exact(detail::decide_boxes_overlap(a, b), exact);
  } else {
    return exact();
  }
}

}  // namespace detent
