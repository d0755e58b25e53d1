// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/closest_point/feature.hpp"
#include "detent/query/distance/segment.hpp"

namespace detent {

/// The square of the distance from `point` to `triangle`: 0 in a 2D one, which is solid, and
/// (n . w)^2 / n^2 above the face of a 3D one, with n = (b - a) x (c - a) and w from a to the
/// point.
///
/// domain: every input; a collapsed triangle is the segment or point that its corners span
/// exact:  the fraction is the exact value                  (tests/oracle/point_triangle.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr auto squared_distance(const Triangle<S, N>& triangle,
                                              const Vec<S, N>& point) noexcept {
  const auto nearest = detail::nearest_feature(triangle, point);
  using ToEdge = decltype(squared_distance(nearest.edge, point));
  if constexpr (N == 2) {
    if (nearest.is_face) return ToEdge{{}, decltype(ToEdge::denominator)(1)};
    return squared_distance(nearest.edge, point);
  } else {
    const auto normal = cross(triangle.b - triangle.a, triangle.c - triangle.a);
    const auto height = dot(normal, point - triangle.a);
    using Over = decltype(height * height);
    using Under = decltype(squared_length(normal));
    using Result = Fraction<Over, Under>;
    if (nearest.is_face) return Result{height * height, squared_length(normal)};
    const ToEdge to_edge = squared_distance(nearest.edge, point);
    return Result{Over(to_edge.numerator), Under(to_edge.denominator)};
  }
}

/// The distance from `point` to `triangle`, 0 inside a 2D one.
///
/// units:  world units
/// domain: every input; a distance beyond the greatest scalar is that
/// exact:  rounded down, error in [0, 1) ULP                (tests/oracle/point_triangle.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr S distance(const Triangle<S, N>& triangle,
                                   const Vec<S, N>& point) noexcept {
  return sqrt_floor<S>(squared_distance(triangle, point));
}

}  // namespace detent
