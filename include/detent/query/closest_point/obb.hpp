// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/point_obb.hpp"

namespace detent {

/// The point of `box` closest to `point` in the frame of the box; `point` itself if inside.
///
/// In that frame a point has the coordinates dot(axis(i), point - center), with the axes exactly as
/// stored. They are clamped to the half extents, and the result is the center plus the sum of
/// clamped coordinate i times axis(i). With orthonormal axes that is the closest point in world
/// space. The axes of a rotation are orthonormal within 2^-29 (2^-13 in 16 bits), so the result is
/// the closest point to that accuracy.
///
/// units:  world units
/// domain: every input; an empty box gives `point`
/// exact:  each coordinate of that sum rounded to nearest, ties to even, and clamped
///         (tests/oracle/point_obb.test.cpp)
/// source: Ericson, Real-Time Collision Detection, 5.1.4
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<S, N> closest_point(const Obb<S, N>& box,
                                                const Vec<S, N>& point) noexcept {
  if (is_empty(box) || detail::holds(box, point)) return point;
  const auto from_center = point - box.center;
  const auto clamped = make_vec<N>([&](int i) {
    return detail::clamp_to(dot(box.rotation.axis(i), from_center), box.half_extents[i]);
  });
  return make_vec<N>([&](int j) {
    const auto row = make_vec<N>([&](int i) { return box.rotation.axis(i)[j]; });
    return nearest_to<S>(box.center[j] + dot(row, clamped));
  });
}

}  // namespace detent
