// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/intersects/reversed.hpp"
#include "detent/query/kernel/segment_triangle.hpp"

namespace detent {

/// Whether `segment` has a point in `triangle`, edges included: a solid in 2D, a surface in 3D.
///
/// domain: every input; a collapsed triangle is the segment or point that its corners span
/// exact:  yes or no exact, also for a segment in the plane of the triangle
///         (tests/oracle/segment_triangle.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool intersects(const Segment<S, N>& segment,
                                        const Triangle<S, N>& triangle) noexcept {
  return detail::segment_meets(segment, triangle);
}

}  // namespace detent
