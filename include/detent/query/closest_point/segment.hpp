// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/closest_point/line.hpp"
#include "detent/shape/segment.hpp"

namespace detent {

/// The point of `segment` that is closest to `point`.
///
/// units:  world units
/// domain: every input; equal ends make it one point
/// exact:  each coordinate is the exact one rounded to nearest, ties to even
///         (tests/oracle/point_segment.test.cpp)
/// source: Ericson, Real-Time Collision Detection, 5.1.2
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<S, N> closest_point(const Segment<S, N>& segment,
                                                const Vec<S, N>& point) noexcept {
  const auto edge = segment.end - segment.start;
  const auto along = dot(point - segment.start, edge);
  const auto whole = squared_length(edge);
  if (along <= 0) return segment.start;
  if (along >= whole) return segment.end;
  return detail::point_on_line(segment.start, edge, along, whole);
}

}  // namespace detent
