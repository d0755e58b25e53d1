// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/point_segment.hpp"

namespace detent {

/// Whether `point` lies on `segment`, ends included.
///
/// domain: every input; equal ends make it a point
/// exact:  yes or no exact                                   (tests/oracle/point_segment.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool contains(const Segment<S, N>& segment,
                                      const Vec<S, N>& point) noexcept {
  return detail::holds(segment, point);
}

}  // namespace detent
