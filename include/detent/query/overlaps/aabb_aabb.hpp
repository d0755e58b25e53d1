// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "detent/shape/aabb.hpp"

namespace detent {

/// Whether two boxes share a point, surfaces included.
///
/// domain: every input; a box with min > max on some axis is empty and overlaps nothing
/// exact:  yes or no exact                                       (tests/oracle/aabb_aabb.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Aabb<S, N>& a, const Aabb<S, N>& b) noexcept {
  for (int i = 0; i < N; ++i) {
    if ((std::max)(a.min[i], b.min[i]) > (std::min)(a.max[i], b.max[i])) return false;
  }
  return true;
}

}  // namespace detent
