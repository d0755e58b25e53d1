// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/intersects/reversed.hpp"
#include "detent/shape/plane.hpp"
#include "detent/shape/segment.hpp"

namespace detent {

/// Whether `segment` has a point in `plane`, with the normal exactly as stored.
///
/// domain: every input; equal ends make a segment a point
/// exact:  yes or no exact                                   (tests/oracle/segment_plane.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool intersects(const Segment<S, N>& segment,
                                        const Plane<S, N>& plane) noexcept {
  const auto start = dot(plane.normal, segment.start), end = dot(plane.normal, segment.end);
  // Not both ends on one side. Sums, because branches on each end would be unpredictable.
  const int above = int{start > plane.offset} + int{end > plane.offset};
  const int below = int{start < plane.offset} + int{end < plane.offset};
  return above != 2 && below != 2;
}

}  // namespace detent
