// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/segment_triangle.hpp"

namespace detent {

namespace detail {

/// Whether the line of some edge of `a`, a 2D triangle with this doubled area, separates it from
/// `b`.
template <Scalar S, Number Area>
[[nodiscard]] constexpr bool edge_separates(const Triangle<S, 2>& a, const Area& area,
                                            const Triangle<S, 2>& b) noexcept {
  const auto is_beyond = [&](const Vec<S, 2>& p, const Vec<S, 2>& q) {
    const auto outside = [&](const Vec<S, 2>& corner) {
      const auto side = cross(q - p, corner - p);
      return area > 0 ? side < 0 : side > 0;
    };
    return outside(b.a) && outside(b.b) && outside(b.c);
  };
  return is_beyond(a.a, a.b) || is_beyond(a.b, a.c) || is_beyond(a.c, a.a);
}

/// The heights of the corners of `b` over the plane of `a`, times its doubled area; a collapsed
/// triangle has no plane and gives zeros.
template <Scalar S>
[[nodiscard]] constexpr auto heights(const Triangle<S, 3>& a, const Triangle<S, 3>& b) noexcept {
  const auto normal = cross(a.b - a.a, a.c - a.a);
  return Vec{dot(normal, b.a - a.a), dot(normal, b.b - a.a), dot(normal, b.c - a.a)};
}

/// Whether an edge of `a` has a point in `b`; the corners of `a` are at these heights over the
/// plane of `b`.
template <Scalar S, Number T>
[[nodiscard]] constexpr bool edge_meets(const Triangle<S, 3>& a, const Vec<T, 3>& over_b,
                                        const Triangle<S, 3>& b) noexcept {
  return (!same_side(over_b.x, over_b.y) && segment_meets(Segment{a.a, a.b}, b)) ||
         (!same_side(over_b.y, over_b.z) && segment_meets(Segment{a.b, a.c}, b)) ||
         (!same_side(over_b.z, over_b.x) && segment_meets(Segment{a.c, a.a}, b));
}

}  // namespace detail

/// Whether two 2D triangles, which are solid, share a point, edges included.
///
/// domain: every input; a collapsed triangle is the segment or point that its corners span
/// exact:  yes or no exact                               (tests/oracle/triangle_triangle.test.cpp)
template <Scalar S>
[[nodiscard]] constexpr bool overlaps(const Triangle<S, 2>& a, const Triangle<S, 2>& b) noexcept {
  const auto area_a = cross(a.b - a.a, a.c - a.a), area_b = cross(b.b - b.a, b.c - b.a);
  if (area_a == 0) return detail::segment_meets(detail::collapsed(a), b);
  if (area_b == 0) return detail::segment_meets(detail::collapsed(b), a);
  return !detail::edge_separates(a, area_a, b) && !detail::edge_separates(b, area_b, a);
}

/// Whether two 3D triangles, which are surfaces, share a point, edges included.
///
/// Their intersection is convex and ends at an edge of one of them.
///
/// domain: every input; a collapsed triangle is the segment or point that its corners span
/// exact:  yes or no exact, also if coplanar              (tests/oracle/triangle_triangle.test.cpp)
/// source: Ericson, Real-Time Collision Detection, 5.2.10
template <Scalar S>
[[nodiscard]] constexpr bool overlaps(const Triangle<S, 3>& a, const Triangle<S, 3>& b) noexcept {
  const auto b_over_a = detail::heights(a, b);
  if (detail::same_side(b_over_a.x, b_over_a.y, b_over_a.z)) return false;
  const auto a_over_b = detail::heights(b, a);
  if (detail::same_side(a_over_b.x, a_over_b.y, a_over_b.z)) return false;
  return detail::edge_meets(a, a_over_b, b) || detail::edge_meets(b, b_over_a, a);
}

}  // namespace detent
