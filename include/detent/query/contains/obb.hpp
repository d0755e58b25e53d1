// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/point_obb.hpp"

namespace detent {

/// Whether `point` is in `box`, surface included.
///
/// The box is {x : |dot(axis(i), x - center)| <= half_extents[i]} with its axes exactly as stored.
///
/// domain: every input; a box with a negative half extent is empty and contains nothing
/// exact:  yes or no exact                                       (tests/oracle/point_obb.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool contains(const Obb<S, N>& box, const Vec<S, N>& point) noexcept {
  return detail::holds(box, point);
}

}  // namespace detent
