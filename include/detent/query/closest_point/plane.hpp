// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/line.hpp"
#include "detent/query/kernel/point_plane.hpp"

namespace detent {

/// The point of `plane` closest to `point`: point - n (dot(n, point) - offset) / dot(n, n), with
/// the normal n exactly as stored.
///
/// units:  world units
/// domain: every input; coordinates are clamped to the scalar's range
/// exact:  each coordinate is the exact one rounded to nearest, ties to even
///         (tests/oracle/point_plane.test.cpp)
/// source: Ericson, Real-Time Collision Detection, 5.1.1
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<S, N> closest_point(const Plane<S, N>& plane,
                                                const Vec<S, N>& point) noexcept {
  const auto depth = narrow_negative(detail::height_above(plane, point));
  return detail::point_on_line(point, plane.normal.vec(),
                               make_ratio_to_unit(depth, squared_length(plane.normal)));
}

}  // namespace detent
