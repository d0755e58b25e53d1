// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

#include "detent/number/filter/ratio.hpp"
#include "detent/number/fraction.hpp"

namespace detent {

/// The leg of a right triangle, sqrt(square - over^2 / under), rounded down to the grid of `T` and
/// clamped, given the ratio over / under. `exact_square()` is the exact square of the leg, a
/// fraction that is not negative.
///
/// Filter: a root in 62 bits, of a square whose only error is that of the ratio. Where that error
/// might cross another square, the exact fraction decides.
template <Number T, Number Square, Number Over, Number Under, int Shift, int Unknown, class Exact>
[[nodiscard]] constexpr T leg_floor(const Square& square,
                                    const FixedRatio<Over, Under, Shift, Unknown>& ratio,
                                    const Exact& exact_square) noexcept {
  if constexpr (is_fixed<T>) {
    static_assert(Square::frac == 2 * T::frac && 2 * Over::frac - Under::frac == Square::frac);
    if (shift_right_floor(square.raw(), 62) == typename Square::raw_type(0)) {
      constexpr std::int64_t margin = std::int64_t{2}
                                      << (std::max)(Over::bits + Unknown - Shift, 0);
      const auto product = wrapping_multiply<Int128>(ratio.over.raw(), ratio.factor);
      const auto rest = integer_cast<std::int64_t>(square.raw()) -
                        integer_cast<std::int64_t>(shift_right_floor(product, Shift));
      const std::int64_t root =
          square_root_floor(static_cast<std::uint64_t>(std::max<std::int64_t>(rest, 0)));
      const std::int64_t beyond = rest - root * root;
      if (margin <= beyond && beyond <= 2 * root - margin) {
        return detail::clamp_root<T>(static_cast<std::uint64_t>(root));
      }
    }
  }
  return sqrt_floor<T>(exact_square());
}

}  // namespace detent
