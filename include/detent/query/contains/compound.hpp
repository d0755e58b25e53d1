// SPDX-License-Identifier: MIT
#pragma once

#include "detent/math/vec.hpp"
#include "detent/shape/compound.hpp"

namespace detent {

/// Whether `point` is in any part of `compound`. Also include the headers of its parts' own
/// queries.
///
/// domain: every input; a compound without parts contains nothing
/// exact:  yes or no exact                               (tests/query/compound.test.cpp)
template <class... Shapes, Scalar S, int N>
[[nodiscard]] constexpr bool contains(const Compound<Shapes...>& compound,
                                      const Vec<S, N>& point) noexcept {
  return any_part(compound, [&](const auto& part) { return contains(part, point); });
}

}  // namespace detent
