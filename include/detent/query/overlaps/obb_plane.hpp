// SPDX-License-Identifier: MIT
#pragma once

#include "detent/shape/obb.hpp"
#include "detent/shape/plane.hpp"

namespace detent {

/// Whether `box`, which is solid, has a point in `plane`, the normal taken exactly as stored.
///
/// The box is the one that its edges span: center + sum of s[i] half_extents[i] axis(i) with
/// |s[i]| <= 1.
///
/// domain: every input; a box with a negative half extent is empty and overlaps nothing
/// exact:  yes or no exact                                       (tests/oracle/obb_plane.test.cpp)
/// source: Ericson, Real-Time Collision Detection, 5.2.3
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Obb<S, N>& box, const Plane<S, N>& plane) noexcept {
  if (is_empty(box)) return false;
  const auto height = dot(plane.normal, box.center) - plane.offset;
  const auto along =
      make_vec<N>([&](int i) { return abs(dot(plane.normal, box.rotation.axis(i))); });
  return abs(height) <= dot(box.half_extents, along);
}

template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Plane<S, N>& plane, const Obb<S, N>& box) noexcept {
  return overlaps(box, plane);
}

}  // namespace detent
