// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/box.hpp"
#include "detent/query/kernel/separation.hpp"
#include "detent/shape/aabb.hpp"
#include "detent/shape/triangle.hpp"

namespace detent {

/// Whether `box` and `triangle` share a point, edges and surfaces included.
///
/// domain: every input; a box with min > max on some axis is empty and overlaps nothing; a
///         collapsed triangle is the segment or point that its corners span
/// exact:  yes or no exact                                   (tests/oracle/aabb_triangle.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Aabb<S, N>& box,
                                      const Triangle<S, N>& triangle) noexcept {
  if (is_empty(box)) return false;
  // Doubled, so that the center of the box is on the grid.
  const auto center = box.min + box.max;
  const auto half_extents = box.max - box.min;
  const auto seen = [&](const Vec<S, N>& corner) { return corner + corner - center; };
  const auto a = seen(triangle.a), b = seen(triangle.b), c = seen(triangle.c);
  if constexpr (N == 2) {
    return !detail::are_apart(std::array{a, b, c},
                              detail::edges_along(Rotation<S, N>(), half_extents));
  } else {
    return detail::box_meets_triangle<bits_of<S> + 2>(detail::WorldFrame(), half_extents, a, b, c);
  }
}

template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Triangle<S, N>& triangle,
                                      const Aabb<S, N>& box) noexcept {
  return overlaps(box, triangle);
}

}  // namespace detent
