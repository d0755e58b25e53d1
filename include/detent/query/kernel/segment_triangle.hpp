// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/collapsed.hpp"
#include "detent/query/kernel/segment_segment.hpp"
#include "detent/shape/triangle.hpp"

namespace detent::detail {

/// Whether all three numbers are positive or all three are negative.
template <Number T>
[[nodiscard]] constexpr bool same_side(const T& a, const T& b, const T& c) noexcept {
  return (a > 0 && b > 0 && c > 0) || (a < 0 && b < 0 && c < 0);
}

enum class Crossing { none, in_plane, point };

/// How a segment meets a 3D triangle with corners 0, `b` and `c`: in no point, in one, or, if it
/// lies in the plane of the triangle, possibly in more. Every segment counts as in the plane of a
/// collapsed triangle.
///
/// The heights n . x of its ends over the plane, for n = b x c, decide whether the segment crosses
/// it. Volumes over the segment are the barycentric weights of the crossing times `whole`.
///
/// source: Moeller and Trumbore, Fast, Minimum Storage Ray-Triangle Intersection (1997)
template <Number T>
[[nodiscard]] constexpr Crossing crossing(const Vec<T, 3>& b, const Vec<T, 3>& c,
                                          const Vec<T, 3>& start, const Vec<T, 3>& end) noexcept {
  const auto normal = cross(b, c);
  const auto at_start = dot(normal, start), at_end = dot(normal, end);
  if (same_side(at_start, at_end)) return Crossing::none;
  if (at_start == 0 && at_end == 0) return Crossing::in_plane;
  const auto moment = cross(end, start);
  const auto whole = at_start - at_end;
  const auto of_b = -dot(c, moment), of_c = dot(b, moment);
  const auto of_a = whole - of_b - of_c;
  const bool inside =
      whole > 0 ? of_a >= 0 && of_b >= 0 && of_c >= 0 : of_a <= 0 && of_b <= 0 && of_c <= 0;
  return inside ? Crossing::point : Crossing::none;
}

/// Whether `segment` has a point in the 2D `triangle`, which is solid, edges included.
///
/// If they are apart, the line of an edge of one separates them, because both are convex.
template <Scalar S>
[[nodiscard]] constexpr bool segment_meets(const Segment<S, 2>& segment,
                                           const Triangle<S, 2>& triangle) noexcept {
  const auto& start = segment.start;
  const auto& end = segment.end;
  const auto& [a, b, c] = triangle;
  const auto area = cross(b - a, c - a);
  if (area == 0) return segments_meet(segment, collapsed(triangle));
  const auto along = end - start;
  if (same_side(cross(along, a - start), cross(along, b - start), cross(along, c - start))) {
    return false;
  }
  // Whether the segment is on the other side of the line from p to q than the triangle.
  const auto is_beyond = [&](const Vec<S, 2>& p, const Vec<S, 2>& q) {
    const auto at_start = cross(q - p, start - p), at_end = cross(q - p, end - p);
    return area > 0 ? at_start < 0 && at_end < 0 : at_start > 0 && at_end > 0;
  };
  return !is_beyond(a, b) && !is_beyond(b, c) && !is_beyond(c, a);
}

/// Whether `segment` has a point in the 3D `triangle`, which is a surface, edges included.
template <Scalar S>
[[nodiscard]] constexpr bool segment_meets(const Segment<S, 3>& segment,
                                           const Triangle<S, 3>& triangle) noexcept {
  const auto& [start, end] = segment;
  const auto& [a, b, c] = triangle;
  const auto edge_b = b - a, edge_c = c - a;
  switch (crossing(edge_b, edge_c, start - a, end - a)) {
    case Crossing::none:
      return false;
    case Crossing::point:
      return true;
    case Crossing::in_plane:
      break;
  }
  const auto normal = cross(edge_b, edge_c);
  if (is_zero(normal)) return segments_meet(segment, collapsed(triangle));
  // In the triangle's plane the other two coordinates decide: drop the normal's longest axis.
  const int axis = longest_axis(normal);
  return segment_meets(Segment{without(start, axis), without(end, axis)},
                       Triangle{without(a, axis), without(b, axis), without(c, axis)});
}

}  // namespace detent::detail
