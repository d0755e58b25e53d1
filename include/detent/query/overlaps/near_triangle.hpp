// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/contains/triangle.hpp"
#include "detent/query/overlaps/near_segment.hpp"

namespace detent::detail {

/// Whether the point at `p` is straight above or below the triangle of 0, `b` and `c`, as seen
/// along its normal; not asked of a collapsed one.
///
/// source: Ericson, Real-Time Collision Detection, 5.4.2
template <Number T, Number P>
[[nodiscard]] constexpr bool is_over_face(const Vec<T, 3>& b, const Vec<T, 3>& c,
                                          const Vec<P, 3>& p) noexcept {
  const auto n = cross(b, c);
  return !is_zero(n) && dot(n, cross(b, p)) >= 0 && dot(n, cross(p, c)) >= 0 &&
         dot(n, cross(c - b, p - b)) >= 0;
}

/// Whether `point` is within `reach` >= 0 of the face of a triangle and straight above it; in 2D,
/// on the face.
template <Scalar S, Number R>
[[nodiscard]] constexpr bool is_near_face(const Triangle<S, 2>& triangle, const Vec<S, 2>& point,
                                          const R&) noexcept {
  return contains(triangle, point);
}
template <Scalar S, Number R>
[[nodiscard]] constexpr bool is_near_face(const Triangle<S, 3>& triangle, const Vec<S, 3>& point,
                                          const R& reach) noexcept {
  const auto b = triangle.b - triangle.a, c = triangle.c - triangle.a, p = point - triangle.a;
  return by_width<29>([](const auto&... x) { return is_over_face(x...); }, b, c, p) &&
         by_width<20>([](const auto&... x) { return is_near_level(x...); }, b, c, p, reach);
}

/// Whether `point` is within `reach` >= 0 of `triangle`: of an edge or of the face.
template <Scalar S, int N, Number R>
[[nodiscard]] constexpr bool is_near(const Triangle<S, N>& triangle, const Vec<S, N>& point,
                                     const R& reach) noexcept {
  const auto& [a, b, c] = triangle;
  return is_near_face(triangle, point, reach) || is_near(Segment{a, b}, point, reach) ||
         is_near(Segment{b, c}, point, reach) || is_near(Segment{c, a}, point, reach);
}

}  // namespace detent::detail
