// SPDX-License-Identifier: MIT
#pragma once

#include "detent/shape/compound.hpp"

namespace detent {

/// Whether any part of `compound` shares a point with `shape`, which may be a compound itself. Also
/// include the headers of the pairs involved, or `query/overlaps.hpp`.
///
/// domain: every input; a compound without parts overlaps nothing
/// exact:  yes or no exact                               (tests/query/compound.test.cpp)
template <class... Shapes, class Shape>
[[nodiscard]] constexpr bool overlaps(const Compound<Shapes...>& compound,
                                      const Shape& shape) noexcept {
  return any_part(compound, [&](const auto& part) { return overlaps(part, shape); });
}
template <class Shape, class... Shapes>
requires(!is_compound<Shape>)
    [[nodiscard]] constexpr bool overlaps(const Shape& shape,
                                          const Compound<Shapes...>& compound) noexcept {
  return overlaps(compound, shape);
}

}  // namespace detent
