// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/intersects/reversed.hpp"
#include "detent/query/kernel/within_segment.hpp"
#include "detent/shape/capsule.hpp"

namespace detent {

/// Whether `segment` and `capsule` share a point.
///
/// domain: every input; a negative radius is an empty capsule and meets nothing
/// exact:  yes or no exact; touching counts                 (tests/oracle/capsule_pairs.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool intersects(const Segment<S, N>& segment,
                                        const Capsule<S, N>& capsule) noexcept {
  return capsule.radius >= 0 &&
         detail::within_reach(segment, Segment{capsule.a, capsule.b}, capsule.radius);
}

}  // namespace detent
