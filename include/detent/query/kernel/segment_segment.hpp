// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "detent/math/components.hpp"
#include "detent/shape/segment.hpp"

namespace detent::detail {

/// Whether two numbers are both positive or both negative.
template <Number A, Number B>
[[nodiscard]] constexpr bool same_side(const A& a, const B& b) noexcept {
  return (a > 0 && b > 0) || (a < 0 && b < 0);
}

/// Whether the bounding boxes of two segments share a point. That decides for collinear segments:
/// the order of a coordinate that changes is the order along the line.
template <Scalar S, int N>
[[nodiscard]] constexpr bool bounds_meet(const Segment<S, N>& p, const Segment<S, N>& q) noexcept {
  for (int i = 0; i < N; ++i) {
    if ((std::max)(p.start[i], p.end[i]) < (std::min)(q.start[i], q.end[i])) return false;
    if ((std::max)(q.start[i], q.end[i]) < (std::min)(p.start[i], p.end[i])) return false;
  }
  return true;
}

/// Whether the ends of `q` are not strictly on the same side of the line through `p`. True if the
/// ends of `p` are equal.
template <Scalar S>
[[nodiscard]] constexpr bool line_meets(const Segment<S, 2>& p, const Segment<S, 2>& q) noexcept {
  const auto along = p.end - p.start;
  return !same_side(cross(along, q.start - p.start), cross(along, q.end - p.start));
}

/// Whether two segments share a point, ends included.
template <Scalar S>
[[nodiscard]] constexpr bool segments_meet(const Segment<S, 2>& p,
                                           const Segment<S, 2>& q) noexcept {
  return bounds_meet(p, q) && line_meets(p, q) && line_meets(q, p);
}

template <Scalar S>
[[nodiscard]] constexpr bool segments_meet(const Segment<S, 3>& p,
                                           const Segment<S, 3>& q) noexcept {
  if (!bounds_meet(p, q)) return false;
  const auto along_p = p.end - p.start, along_q = q.end - q.start, apart = q.start - p.start;
  const auto normal = cross(along_p, along_q);
  if (is_zero(normal)) {
    return are_parallel(along_p, apart) && are_parallel(along_q, apart);
  }
  if (dot(normal, apart) != 0) return false;
  // In their common plane the other two coordinates decide: drop the normal's longest axis.
  const int axis = longest_axis(normal);
  const Segment p2{without(p.start, axis), without(p.end, axis)};
  const Segment q2{without(q.start, axis), without(q.end, axis)};
  return line_meets(p2, q2) && line_meets(q2, p2);
}

}  // namespace detent::detail
