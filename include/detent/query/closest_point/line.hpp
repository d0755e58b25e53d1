// SPDX-License-Identifier: MIT
#pragma once

#include "detent/math/direction.hpp"

namespace detent::detail {

/// origin + direction * (over / under), each coordinate the exact quotient rounded to nearest, ties
/// to even, and clamped to the range of the scalar; under > 0.
template <Scalar S, Number T, Number Over, Number Under, int N>
[[nodiscard]] constexpr Vec<S, N> point_on_line(const Vec<S, N>& origin, const Vec<T, N>& direction,
                                                const Over& over, const Under& under) noexcept {
  return make_vec<N>(
      [&](int i) { return quotient_nearest<S>(origin[i] * under + direction[i] * over, under); });
}

}  // namespace detent::detail
