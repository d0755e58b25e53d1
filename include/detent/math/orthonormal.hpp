// SPDX-License-Identifier: MIT
#pragma once

#include "detent/math/rotation.hpp"
#include "detent/math/width.hpp"

namespace detent::detail {

/// Whether every two axes are perpendicular within 2^-Bits; their lengths are 1 within 2^-13.
template <int Bits, Scalar S, int N>
[[nodiscard]] constexpr bool are_perpendicular(const Rotation<S, N>& rotation) noexcept {
  bool all = true;  // no branch per pair
  for (int i = 0; i < N; ++i) {
    for (int j = 0; j < i; ++j) {
      const auto cosine = dot(rotation.axis(i), rotation.axis(j));
      if constexpr (is_fixed<S>) {
        all = fits<2 * direction_component<S>::frac - Bits>(cosine) && all;
      } else {
        all = !((1 << Bits) * abs(cosine) > 1) && all;
      }
    }
  }
  return all;
}

}  // namespace detent::detail
