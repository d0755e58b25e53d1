// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/planar.hpp"

namespace detent::detail {

/// Whether two vectors, or a direction and a vector, are parallel; 0 is parallel to every vector.
template <class U, Number T, int N>
[[nodiscard]] constexpr bool are_parallel(const U& u, const Vec<T, N>& v) noexcept {
  const auto area = cross(u, v);
  if constexpr (N == 2) {
    return area == 0;
  } else {
    return is_zero(area);
  }
}

}  // namespace detent::detail
