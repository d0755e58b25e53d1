// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "detent/query/kernel/box.hpp"
#include "detent/query/kernel/box_triangle_filter.hpp"
#include "detent/query/kernel/separation.hpp"
#include "detent/shape/obb.hpp"
#include "detent/shape/triangle.hpp"

namespace detent {

/// Whether `box` and `triangle` share a point, edges and surfaces included.
///
/// The box is the one that its edges span: center + sum of s[i] half_extents[i] axis(i) with
/// |s[i]| <= 1.
///
/// domain: every input; a box with a negative half extent is empty and overlaps nothing; a
///         collapsed triangle is the segment or point that its corners span
/// exact:  yes or no exact                                    (tests/oracle/obb_triangle.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Obb<S, N>& box,
                                      const Triangle<S, N>& triangle) noexcept {
  if (is_empty(box)) return false;
  const auto a = triangle.a - box.center;
  const auto b = triangle.b - box.center;
  const auto c = triangle.c - box.center;
  const auto exact = [&] {
    if constexpr (N == 3) {
      const detail::EdgeFrame<S> frame(box.rotation);
      if (!frame.is_flat()) {
        return detail::box_meets_triangle<bits_of<S> + 1>(frame, box.half_extents, a, b, c);
      }
    }
    // The stored axes may all lie in one plane. Together with the world's own they span space.
    return !detail::are_apart(std::array{a, b, c},
                              detail::edges_along(Rotation<S, N>(), Vec<S, N>()),
                              detail::edges_along(box.rotation, box.half_extents));
  };
  if constexpr (N == 3 && filter_pays<S>) {
    return or_exact(detail::decide_box_meets_triangle(detail::AxisFrame(box.rotation),
                                                      box.half_extents, std::array{a, b, c}),
                    exact);
  } else {
    return exact();
  }
}

template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Triangle<S, N>& triangle,
                                      const Obb<S, N>& box) noexcept {
  return overlaps(box, triangle);
}

}  // namespace detent
