// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/intersects/hull.hpp"
#include "detent/query/kernel/beyond.hpp"

namespace detent {

/// Whether `segment` and `frustum` share a point.
///
/// domain: every input; equal ends make the segment a point
/// exact:  yes or no exact, for the hull of the corners; touching counts
///         (tests/oracle/frustum.test.cpp)
template <Scalar S>
[[nodiscard]] constexpr bool intersects(const Segment<S, 3>& segment,
                                        const Frustum<S>& frustum) noexcept {
  return !detail::is_beyond(frustum, segment) && intersects(segment, frustum.hull());
}

}  // namespace detent
