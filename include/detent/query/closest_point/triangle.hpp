// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/closest_point/segment.hpp"
#include "detent/query/kernel/feature.hpp"

namespace detent {

namespace detail {

/// The point closest to `point` on the plane spanned by `b` and `c`; `w` leads from their common
/// start to `point`.
template <Scalar S, Number T>
[[nodiscard]] constexpr Vec<S, 3> closest_on_plane(const Vec<S, 3>& point, const Vec<T, 3>& b,
                                                   const Vec<T, 3>& c,
                                                   const Vec<T, 3>& w) noexcept {
  const auto normal = cross(b, c);
  return point_on_line(point, normal, make_ratio(-dot(normal, w), squared_length(normal)));
}

}  // namespace detail

/// The point of `triangle` closest to `point`; `point` itself if inside a 2D triangle, which is
/// solid.
///
/// units:  world units
/// domain: every input; a collapsed triangle is the segment or point that its corners span
/// exact:  each coordinate is the exact one rounded to nearest, ties to even
///         (tests/oracle/point_triangle.test.cpp)
/// source: Ericson, Real-Time Collision Detection, 5.1.5
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<S, N> closest_point(const Triangle<S, N>& triangle,
                                                const Vec<S, N>& point) noexcept {
  const auto nearest = detail::nearest_feature(triangle, point);
  if (!nearest.is_face) return closest_point(nearest.edge, point);
  if constexpr (N == 2) {
    return point;
  } else {
    return by_width<30>([&](const auto&... x) { return detail::closest_on_plane(point, x...); },
                        triangle.b - triangle.a, triangle.c - triangle.a, point - triangle.a);
  }
}

}  // namespace detent
