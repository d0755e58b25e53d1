// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/intersects/reversed.hpp"
#include "detent/shape/compound.hpp"
#include "detent/shape/segment.hpp"

namespace detent {

/// Whether `segment` has a point in common with any part of `compound`. Include the headers of its
/// parts' own queries too.
///
/// domain: every input; no parts intersect nothing
/// exact:  yes or no exact                               (tests/query/compound.test.cpp)
template <Scalar S, int N, class... Shapes>
[[nodiscard]] constexpr bool intersects(const Segment<S, N>& segment,
                                        const Compound<Shapes...>& compound) noexcept {
  return any_part(compound, [&](const auto& part) { return intersects(segment, part); });
}

}  // namespace detent
