// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/intersects/reversed.hpp"
#include "detent/query/kernel/within_segment.hpp"
#include "detent/shape/sphere.hpp"

namespace detent {

/// Whether `segment` and `sphere` share a point.
///
/// domain: every input; a negative radius is an empty sphere and meets nothing
/// exact:  yes or no exact; touching counts                  (tests/oracle/sphere_edges.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool intersects(const Segment<S, N>& segment,
                                        const Sphere<S, N>& sphere) noexcept {
  return sphere.radius >= 0 && detail::within_reach(segment, sphere.center, sphere.radius);
}

}  // namespace detent
