// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "detent/number/rounding.hpp"

namespace detent {

/// Rounds an exact value to nearest, ties to even, given `x` within 2^-12 steps of `S` of it.
///
/// Filter: where `x` does not decide on which side of a midpoint between two steps the value lies,
/// `sign_of_difference(middle)` does, the sign of the value minus the midpoint. The result must
/// fit.
template <class S, int B, int F, class Sign>
[[nodiscard]] constexpr S nearest_by(const Fixed<B, F>& x,
                                     const Sign& sign_of_difference) noexcept {
  constexpr int shift = F - S::frac;
  static_assert(shift >= 12 && B <= 63);
  constexpr std::uint64_t half = std::uint64_t{1} << (shift - 1), margin = half >> 11;
  const std::int64_t raw = x.raw();
  std::int64_t nearest = shift_right_floor(raw + std::int64_t{half}, shift);
  const std::uint64_t fraction = static_cast<std::uint64_t>(raw) & (2 * half - 1);
  if (fraction - (half - margin) <= 2 * margin) [[unlikely]] {
    using Middle = Fixed<S::bits + 1, S::frac + 1>;
    using Raw = typename Middle::raw_type;
    const std::int64_t below = shift_right_floor(raw, shift);
    const int sign = sign_of_difference(Middle::assume_raw(static_cast<Raw>(2 * below + 1)));
    nearest = below + (sign > 0 || (sign == 0 && (below & 1) != 0) ? 1 : 0);
  }
  return S::assume_raw(static_cast<typename S::raw_type>(nearest));
}

}  // namespace detent
