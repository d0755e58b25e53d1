// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/intersects/reversed.hpp"
#include "detent/shape/compound.hpp"
#include "detent/shape/segment.hpp"

namespace detent {

/// Whether `segment` shares a point with any part of `compound`. Also include the headers of its
/// parts' own queries.
///
/// domain: every input; a compound without parts intersects nothing
/// exact:  yes or no exact                               (tests/query/compound.test.cpp)
template <Scalar S, int N, class... Shapes>
[[nodiscard]] constexpr bool intersects(const Segment<S, N>& segment,
                                        const Compound<Shapes...>& compound) noexcept {
  return any_part(compound, [&](const auto& part) { return intersects(segment, part); });
}

}  // namespace detent
