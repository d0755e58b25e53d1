// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/closest_point/feature.hpp"
#include "detent/query/closest_point/segment.hpp"

namespace detent {

/// The point of `triangle` that is closest to `point`, which is `point` itself in a 2D triangle,
/// which is solid.
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
    const auto normal = cross(triangle.b - triangle.a, triangle.c - triangle.a);
    const auto height = dot(normal, point - triangle.a);
    return detail::point_on_line(point, normal, -height, squared_length(normal));
  }
}

}  // namespace detent
