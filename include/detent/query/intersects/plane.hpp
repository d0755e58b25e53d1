// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "detent/shape/plane.hpp"
#include "detent/shape/segment.hpp"

namespace detent {

/// Whether `segment` has a point in `plane`, the normal taken exactly as stored.
///
/// domain: every input; equal ends make a segment one point
/// exact:  yes or no exact                                   (tests/oracle/segment_plane.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool intersects(const Segment<S, N>& segment,
                                        const Plane<S, N>& plane) noexcept {
  const auto start = dot(plane.normal, segment.start), end = dot(plane.normal, segment.end);
  return std::min(start, end) <= plane.offset && plane.offset <= std::max(start, end);
}

}  // namespace detent
