// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/segment_segment.hpp"

namespace detent {

/// Whether two segments share a point, ends included.
///
/// domain: every input; equal ends make a segment a point
/// exact:  yes or no exact                                 (tests/oracle/segment_segment.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool intersects(const Segment<S, N>& p, const Segment<S, N>& q) noexcept {
  return detail::segments_meet(p, q);
}

}  // namespace detent
