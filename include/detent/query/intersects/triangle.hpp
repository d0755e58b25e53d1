// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/intersects/segment.hpp"
#include "detent/shape/triangle.hpp"

namespace detent {

namespace detail {

/// Whether all three numbers, the places of a triangle's corners, are on the same side of 0.
template <Number T>
[[nodiscard]] constexpr bool same_side(const T& a, const T& b, const T& c) noexcept {
  return (a > 0 && b > 0 && c > 0) || (a < 0 && b < 0 && c < 0);
}

}  // namespace detail

/// Whether `segment` has a point in the 2D `triangle`, a solid, its edges included.
///
/// Two convex sets of the plane that are apart have the line of an edge of one between them.
///
/// domain: every input; a collapsed triangle is the segment or point that its corners span
/// exact:  yes or no exact                                (tests/oracle/segment_triangle.test.cpp)
template <Scalar S>
[[nodiscard]] constexpr bool intersects(const Segment<S, 2>& segment,
                                        const Triangle<S, 2>& triangle) noexcept {
  const auto& start = segment.start;
  const auto& end = segment.end;
  const auto& [a, b, c] = triangle;
  const auto area = cross(b - a, c - a);
  if (area == 0) return intersects(segment, detail::collapsed(triangle));
  const auto along = end - start;
  if (detail::same_side(cross(along, a - start), cross(along, b - start),
                        cross(along, c - start))) {
    return false;
  }
  // Whether the segment is on the other side of the line from p to q than the triangle.
  const auto is_beyond = [&](const Vec<S, 2>& p, const Vec<S, 2>& q) {
    const auto at_start = cross(q - p, start - p), at_end = cross(q - p, end - p);
    return area > 0 ? at_start < 0 && at_end < 0 : at_start > 0 && at_end > 0;
  };
  return !is_beyond(a, b) && !is_beyond(b, c) && !is_beyond(c, a);
}

/// Whether `segment` has a point in the 3D `triangle`, a surface, its edges included.
///
/// With n = (b - a) x (c - a), its heights n . (x - a) over the plane tell whether the segment
/// crosses it, and volumes over the segment in which point of the triangle.
///
/// domain: every input; a collapsed triangle is the segment or point that its corners span
/// exact:  yes or no exact, for a segment in the plane of the triangle too
///         (tests/oracle/segment_triangle.test.cpp)
/// source: Moeller and Trumbore, Fast, Minimum Storage Ray-Triangle Intersection (1997)
template <Scalar S>
[[nodiscard]] constexpr bool intersects(const Segment<S, 3>& segment,
                                        const Triangle<S, 3>& triangle) noexcept {
  const auto& [start, end] = segment;
  const auto& [a, b, c] = triangle;
  const auto edge_b = b - a, edge_c = c - a, from_a = start - a;
  const auto normal = cross(edge_b, edge_c);
  const auto at_start = dot(normal, from_a), at_end = dot(normal, end - a);
  if (detail::same_side(at_start, at_end)) return false;
  if (at_start == 0 && at_end == 0) {
    if (detail::is_zero(normal)) return intersects(segment, detail::collapsed(triangle));
    // In the plane of the triangle, what the axis most along its normal hides decides nothing.
    const int axis = detail::longest_axis(normal);
    return intersects(
        Segment{detail::without(start, axis), detail::without(end, axis)},
        Triangle{detail::without(a, axis), detail::without(b, axis), detail::without(c, axis)});
  }
  // `whole` times the barycentric weights of b and c at the crossing, and what they leave to a.
  const auto moment = cross(end - start, from_a);
  const auto whole = at_start - at_end;
  const auto of_b = -dot(edge_c, moment), of_c = dot(edge_b, moment);
  const auto of_a = whole - of_b - of_c;
  return whole > 0 ? of_a >= 0 && of_b >= 0 && of_c >= 0 : of_a <= 0 && of_b <= 0 && of_c <= 0;
}

}  // namespace detent
