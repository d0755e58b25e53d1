// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "detent/query/kernel/parallel.hpp"
#include "detent/shape/segment.hpp"

namespace detent {

namespace detail {

/// Whether two numbers are both positive or both negative.
template <Number A, Number B>
[[nodiscard]] constexpr bool same_side(const A& a, const B& b) noexcept {
  return (a > 0 && b > 0) || (a < 0 && b < 0);
}

/// Whether the bounding boxes of two segments share a point. For collinear segments that decides:
/// the order of a coordinate that changes is the order along the line.
template <Scalar S, int N>
[[nodiscard]] constexpr bool bounds_meet(const Segment<S, N>& p, const Segment<S, N>& q) noexcept {
  for (int i = 0; i < N; ++i) {
    if ((std::max)(p.start[i], p.end[i]) < (std::min)(q.start[i], q.end[i])) return false;
    if ((std::max)(q.start[i], q.end[i]) < (std::min)(p.start[i], p.end[i])) return false;
  }
  return true;
}

/// Whether the ends of `q` are not strictly on one side of the line through `p`. True if the ends
/// of `p` are equal.
template <Scalar S>
[[nodiscard]] constexpr bool line_meets(const Segment<S, 2>& p, const Segment<S, 2>& q) noexcept {
  const auto along = p.end - p.start;
  return !same_side(cross(along, q.start - p.start), cross(along, q.end - p.start));
}

}  // namespace detail

/// Whether two segments share a point, ends included.
///
/// domain: every input; equal ends make a segment a point
/// exact:  yes or no exact                                 (tests/oracle/segment_segment.test.cpp)
template <Scalar S>
[[nodiscard]] constexpr bool intersects(const Segment<S, 2>& p, const Segment<S, 2>& q) noexcept {
  return detail::bounds_meet(p, q) && detail::line_meets(p, q) && detail::line_meets(q, p);
}

/// Whether two segments share a point, ends included.
///
/// domain: every input; equal ends make a segment a point
/// exact:  yes or no exact                                 (tests/oracle/segment_segment.test.cpp)
template <Scalar S>
[[nodiscard]] constexpr bool intersects(const Segment<S, 3>& p, const Segment<S, 3>& q) noexcept {
  if (!detail::bounds_meet(p, q)) return false;
  const auto along_p = p.end - p.start, along_q = q.end - q.start, apart = q.start - p.start;
  const auto normal = cross(along_p, along_q);
  if (detail::is_zero(normal)) {
    return detail::are_parallel(along_p, apart) && detail::are_parallel(along_q, apart);
  }
  if (dot(normal, apart) != 0) return false;
  // In their common plane the other two coordinates decide: drop the normal's longest axis.
  const int axis = detail::longest_axis(normal);
  const Segment p2{detail::without(p.start, axis), detail::without(p.end, axis)};
  const Segment q2{detail::without(q.start, axis), detail::without(q.end, axis)};
  return detail::line_meets(p2, q2) && detail::line_meets(q2, p2);
}

}  // namespace detent
