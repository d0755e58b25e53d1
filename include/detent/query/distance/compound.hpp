// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "detent/math/vec.hpp"
#include "detent/shape/compound.hpp"

namespace detent {

/// The distance from `point` to the nearest part of `compound`, 0 inside. Also include the headers
/// of its parts' own queries.
///
/// units:  world units
/// domain: every input; clamped to the greatest scalar, which is the result for a compound without
///         parts
/// exact:  rounded down, error in [0, 1) ULP             (tests/query/compound.test.cpp)
template <class... Shapes, Scalar S, int N>
[[nodiscard]] constexpr S distance(const Compound<Shapes...>& compound,
                                   const Vec<S, N>& point) noexcept {
  S least = largest<S>;
  for_each_part(compound,
                [&](const auto& part) { least = (std::min)(least, distance(part, point)); });
  return least;
}

}  // namespace detent
