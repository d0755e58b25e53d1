// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/point_segment.hpp"

namespace detent {

/// The squared distance from `point` to `segment`: |w x e|^2 / |e|^2 where the point projects
/// between the ends, with w from the start to the point and e along the segment.
///
/// domain: every input; equal ends make it a point
/// exact:  the fraction is the exact value                   (tests/oracle/point_segment.test.cpp)
/// source: Ericson, Real-Time Collision Detection, 5.1.2.1
template <Scalar S, int N>
[[nodiscard]] constexpr auto squared_distance(const Segment<S, N>& segment,
                                              const Vec<S, N>& point) noexcept {
  return detail::squared_distance_from_edge(segment.end - segment.start, point - segment.start);
}

/// The distance from `point` to `segment`.
///
/// units:  world units
/// domain: every input; clamped to the greatest scalar
/// exact:  rounded down, error in [0, 1) ULP                 (tests/oracle/point_segment.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr S distance(const Segment<S, N>& segment, const Vec<S, N>& point) noexcept {
  return detail::distance_to<S>(segment, point);
}

}  // namespace detent
