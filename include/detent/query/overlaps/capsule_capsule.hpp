// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/within_segment.hpp"
#include "detent/shape/capsule.hpp"

namespace detent {

/// Whether two capsules share a point: their segments come within the sum of the radii.
///
/// domain: every input; a negative radius is an empty capsule and overlaps nothing
/// exact:  yes or no exact; touching counts                 (tests/oracle/capsule_pairs.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Capsule<S, N>& a, const Capsule<S, N>& b) noexcept {
  return a.radius >= 0 && b.radius >= 0 &&
         detail::within_reach(Segment{a.a, a.b}, Segment{b.a, b.b}, a.radius + b.radius);
}

}  // namespace detent
