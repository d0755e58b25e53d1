// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/parallel.hpp"
#include "detent/shape/segment.hpp"

namespace detent {

/// Whether `point` lies on `segment`, ends included.
///
/// domain: every input; equal ends make it a point
/// exact:  yes or no exact                                   (tests/oracle/point_segment.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool contains(const Segment<S, N>& segment,
                                      const Vec<S, N>& point) noexcept {
  const auto& [start, end] = segment;
  for (int i = 0; i < N; ++i) {
    if (point[i] < start[i] && point[i] < end[i]) return false;
    if (point[i] > start[i] && point[i] > end[i]) return false;
  }
  return detail::are_parallel(end - start, point - start);
}

}  // namespace detent
