// SPDX-License-Identifier: MIT
#pragma once

#include "detent/math/width.hpp"
#include "detent/query/kernel/line.hpp"
#include "detent/shape/segment.hpp"

namespace detent {

/// The point of `segment` closest to `point`.
///
/// units:  world units
/// domain: every input; equal ends make it a point
/// exact:  each coordinate is the exact one rounded to nearest, ties to even
///         (tests/oracle/point_segment.test.cpp)
/// source: Ericson, Real-Time Collision Detection, 5.1.2
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<S, N> closest_point(const Segment<S, N>& segment,
                                                const Vec<S, N>& point) noexcept {
  return by_width<30>(
      [&](const auto& edge, const auto& from_start) {
        const auto along = dot(from_start, edge);
        const auto whole = squared_length(edge);
        if (along <= 0) return segment.start;
        if (along >= whole) return segment.end;
        return detail::point_on_line(segment.start, edge, make_ratio_below_one(along, whole));
      },
      segment.end - segment.start, point - segment.start);
}

}  // namespace detent
