// SPDX-License-Identifier: MIT
#pragma once

#include "detent/shape/aabb.hpp"

namespace detent {

/// Whether `point` is in `box`, surface included.
///
/// domain: every input; a box with min > max on some axis is empty and contains nothing
/// exact:  yes or no exact                                      (tests/oracle/point_aabb.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool contains(const Aabb<S, N>& box, const Vec<S, N>& point) noexcept {
  for (int i = 0; i < N; ++i) {
    if (point[i] < box.min[i] || point[i] > box.max[i]) return false;
  }
  return true;
}

}  // namespace detent
