// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>

#include "detent/shape/aabb.hpp"
#include "detent/shape/plane.hpp"

namespace detent {

/// Whether `box`, which is solid, has a point in `plane`, with the normal exactly as stored.
///
/// domain: every input; a box with min > max on some axis is empty and overlaps nothing
/// exact:  yes or no exact                                      (tests/oracle/aabb_plane.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Aabb<S, N>& box, const Plane<S, N>& plane) noexcept {
  if (is_empty(box)) return false;
  // Doubled: the corners farthest back and farthest along the normal lie at the center minus and
  // plus the reach of the sides.
  const auto& normal = plane.normal;
  constexpr int bits = detail::along_bits<S, decltype(box.min.x + box.max.x)>;
  const auto center = dot(normal, box.min + box.max);
  const auto along = make_vec<N>([&](int i) { return abs(normal[i]); });
  const auto reach = narrow_dot<bits>(box.max - box.min, along);
  const std::remove_cvref_t<decltype(center)> offset(plane.offset + plane.offset);
  return narrow_difference<bits>(center, reach) <= offset &&
         offset <= narrow_sum<bits>(center, reach);
}

template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Plane<S, N>& plane, const Aabb<S, N>& box) noexcept {
  return overlaps(box, plane);
}

}  // namespace detent
