// SPDX-License-Identifier: MIT
#pragma once

#include "detent/math/rotation.hpp"

namespace detent::detail {

/// Whether the axes are perpendicular and of length 1 within 2^-10.
template <Scalar S, int N>
[[nodiscard]] constexpr bool is_nearly_orthonormal(const Rotation<S, N>& rotation) noexcept {
  for (int i = 0; i < N; ++i) {
    for (int j = 0; j < i; ++j) {
      // Directions are of length 1 within 2^-13.
      const auto cosine = dot(rotation.axis(i), rotation.axis(j));
      if constexpr (is_fixed<S>) {
        if (abs(cosine) > Fixed<1, 10>::from_raw(1)) return false;
      } else {
        if (1024 * abs(cosine) > 1) return false;
      }
    }
  }
  return true;
}

}  // namespace detent::detail
