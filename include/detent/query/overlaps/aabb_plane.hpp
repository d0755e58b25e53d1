// SPDX-License-Identifier: MIT
#pragma once

#include "detent/shape/aabb.hpp"
#include "detent/shape/plane.hpp"

namespace detent {

/// Whether `box`, which is solid, has a point in `plane`, the normal taken exactly as stored.
///
/// domain: every input; a box with min > max on some axis is empty and overlaps nothing
/// exact:  yes or no exact                                      (tests/oracle/aabb_plane.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Aabb<S, N>& box, const Plane<S, N>& plane) noexcept {
  if (is_empty(box)) return false;
  // The corners farthest back and farthest along the normal.
  const auto& normal = plane.normal;
  const auto back = make_vec<N>([&](int i) { return normal[i] < 0 ? box.max[i] : box.min[i]; });
  const auto front = make_vec<N>([&](int i) { return normal[i] < 0 ? box.min[i] : box.max[i]; });
  return dot(normal, back) <= plane.offset && plane.offset <= dot(normal, front);
}

template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Plane<S, N>& plane, const Aabb<S, N>& box) noexcept {
  return overlaps(box, plane);
}

}  // namespace detent
