// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/distance/segment.hpp"
#include "detent/query/kernel/feature.hpp"

namespace detent {

namespace detail {

/// The squared distance from the point `w` to the plane through 0 spanned by `b` and `c`:
/// (n . w)^2 / n^2 with n = b x c.
template <Number T>
[[nodiscard]] constexpr auto squared_distance_from_face(const Vec<T, 3>& b, const Vec<T, 3>& c,
                                                        const Vec<T, 3>& w) noexcept {
  const auto normal = cross(b, c);
  return Fraction{square(dot(normal, w)), squared_length(normal)};
}

}  // namespace detail

/// The squared distance from `point` to `triangle`: 0 inside a 2D triangle, which is solid, and
/// (n . w)^2 / n^2 above the face of a 3D triangle, with n = (b - a) x (c - a) and w from a to the
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
    const auto to_face = detail::squared_distance_from_face(
        triangle.b - triangle.a, triangle.c - triangle.a, point - triangle.a);
    using Result = decltype(to_face);
    if (nearest.is_face) return to_face;
    const ToEdge to_edge = squared_distance(nearest.edge, point);
    return Result{decltype(to_face.numerator)(to_edge.numerator),
                  decltype(to_face.denominator)(to_edge.denominator)};
  }
}

namespace detail {

/// `distance` to a triangle, in a result type that may differ from its coordinates.
template <Number Distance, Scalar S, int N>
[[nodiscard]] constexpr Distance distance_to(const Triangle<S, N>& triangle,
                                             const Vec<S, N>& point) noexcept {
  const auto nearest = nearest_feature(triangle, point);
  if (!nearest.is_face) return distance_to<Distance>(nearest.edge, point);
  if constexpr (N == 2) {
    return Distance(0);
  } else {
    return by_width<20>(
        [](const auto&... x) { return sqrt_floor<Distance>(squared_distance_from_face(x...)); },
        triangle.b - triangle.a, triangle.c - triangle.a, point - triangle.a);
  }
}

}  // namespace detail

/// The distance from `point` to `triangle`, 0 inside a 2D triangle.
///
/// units:  world units
/// domain: every input; clamped to the greatest scalar
/// exact:  rounded down, error in [0, 1) ULP                (tests/oracle/point_triangle.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr S distance(const Triangle<S, N>& triangle,
                                   const Vec<S, N>& point) noexcept {
  return detail::distance_to<S>(triangle, point);
}

}  // namespace detent
