// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "detent/query/intersects/reversed.hpp"
#include "detent/query/kernel/gjk.hpp"
#include "detent/shape/segment.hpp"

namespace detent {

/// Whether `segment` and `hull` share a point.
///
/// domain: every input; equal ends make the segment a point; an empty hull meets nothing
/// exact:  yes or no exact; touching counts                    (tests/oracle/hull_pairs.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool intersects(const Segment<S, N>& segment,
                                        const ConvexHull<S, N>& hull) noexcept {
  const std::array ends{segment.start, segment.end};
  return !is_empty(hull) &&
         detail::bodies_overlap(detail::HullBody(ConvexHull{ends}), detail::HullBody(hull));
}

}  // namespace detent
