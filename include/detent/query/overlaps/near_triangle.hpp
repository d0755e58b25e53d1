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

/// Whether `point` is straight above or below the face of `triangle`, where no edge is closer; in
/// 2D, whether it is in the triangle.
template <Scalar S>
[[nodiscard]] constexpr bool is_over_face(const Triangle<S, 2>& triangle,
                                          const Vec<S, 2>& point) noexcept {
  return contains(triangle, point);
}
template <Scalar S>
[[nodiscard]] constexpr bool is_over_face(const Triangle<S, 3>& triangle,
                                          const Vec<S, 3>& point) noexcept {
  const auto& [a, b, c] = triangle;
  return by_width<29>([](const auto&... x) { return is_over_face(x...); }, b - a, c - a, point - a);
}

/// Whether `point`, which is over the face of `triangle`, is within `reach` >= 0 of it.
template <Scalar S, Number R>
[[nodiscard]] constexpr bool is_near_face(const Triangle<S, 2>&, const Vec<S, 2>&,
                                          const R&) noexcept {
  return true;
}
template <Scalar S, Number R>
[[nodiscard]] constexpr bool is_near_face(const Triangle<S, 3>& triangle, const Vec<S, 3>& point,
                                          const R& reach) noexcept {
  const auto& [a, b, c] = triangle;
  return by_width<20>([](const auto&... x) { return is_near_level(x...); }, b - a, c - a, point - a,
                      reach);
}

/// Whether `point` is within `reach` >= 0 of `triangle`: of the face, or of an edge beside it.
template <Scalar S, int N, Number R>
[[nodiscard]] constexpr bool is_near(const Triangle<S, N>& triangle, const Vec<S, N>& point,
                                     const R& reach) noexcept {
  const auto& [a, b, c] = triangle;
  if (are_apart(std::array{a, b, c}, std::array{point}, reach)) return false;
  if (is_over_face(triangle, point)) return is_near_face(triangle, point, reach);
  return is_near(Segment{a, b}, point, reach) || is_near(Segment{b, c}, point, reach) ||
         is_near(Segment{c, a}, point, reach);
}

}  // namespace detent::detail
