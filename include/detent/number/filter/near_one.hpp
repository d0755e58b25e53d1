// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "detent/number/rounding.hpp"

namespace detent {

/// A quotient rounded down and clamped. `is_close`: whether a numerator smaller by up to a given
/// number of its steps may have another quotient, because the remainder is less than those steps.
template <class T>
struct NearQuotient {
  T quotient;
  bool is_close;
};

/// n / d for n >= 0 and d > 0, rounded down to the grid of `T`, which is no finer than n's; fast
/// where d is the squared length of a direction, 1 within 2^-28.
///
/// For d = 1 + e the quotient is n (1 - e + e^2 - ...). So n - n e, taken on the grid of T, is at
/// most a few steps off. The remainder is small enough to be computed modulo 2^64 and gives the
/// number of steps. The numerator may be too large by up to 2^`unknown_bits` of its steps.
template <class T, int BN, int FN, int BD, int FD>
[[nodiscard]] constexpr NearQuotient<T> divide_near_one(const Fixed<BN, FN>& n,
                                                        const Fixed<BD, FD>& d,
                                                        int unknown_bits) noexcept {
  using Grid = detail::GridQuotient<T, Fixed<BN, FN>, Fixed<BD, FD>>;
  using Integer = typename Grid::Integer;
  constexpr int shift = Grid::shift;  // numerator * 2^shift / denominator is the quotient
  static_assert(shift >= 0 && FD >= shift);
  if constexpr (value_bits < Integer >> 63 && BN <= 63 && FD > 28 && FD <= 60 && BD <= 63) {
    constexpr std::int64_t one = std::int64_t{1} << FD;
    const auto excess = integer_cast<std::int64_t>(wrapping_subtract<std::int64_t>(d.raw(), one));
    constexpr std::int64_t tolerance = std::int64_t{1} << (FD - 28);
    if (-tolerance <= excess && excess <= tolerance) {
      const auto numerator = integer_cast<std::int64_t>(n.raw());
      const std::int64_t whole = shift_right_floor(numerator, FD - shift);
      // |whole excess| < 2^(63 - 30) * 2^32; rounded to nearest, so that small ones vanish.
      const auto correction = integer_cast<std::int64_t>(shift_right_floor(
          wrapping_add<Int128>(wrapping_multiply<Int128>(whole, excess), one / 2), FD));
      std::int64_t quotient = whole - correction;
      auto rest = wrapping_subtract<std::int64_t>(
          shift_left(numerator, shift), wrapping_multiply<std::int64_t>(quotient, d.raw()));
      for (; rest < 0; rest += d.raw()) --quotient;
      for (; rest >= d.raw(); rest -= d.raw()) ++quotient;
      return {detail::clamp_raw<T>(quotient), shift_right_floor(rest, shift + unknown_bits) == 0};
    }
  }
  Integer divisor;
  const auto [quotient, rest] = Grid::divide(n, d, divisor);
  return {detail::clamp_raw<T>(quotient),
          shift_right_floor(rest, shift + unknown_bits) == Integer(0)};
}

/// |n| / sqrt(d), rounded down to the grid of `T` and clamped, where d is the squared length of a
/// direction: 1 within 2^-28, or 2^-12 in 16 bits.
///
/// 1 / sqrt(1 + e) = 1 - e / 2 + ...: the rest of the series is below 3 e^2 / 8, which is less than
/// 2^6 steps of n. The squares are compared only where that might cross a step of T.
template <class T, int BN, int FN, int BD, int FD>
[[nodiscard]] constexpr T divide_by_length(const Fixed<BN, FN>& n,
                                           const Fixed<BD, FD>& d) noexcept {
  constexpr int shift = FN - T::frac;
  static_assert(shift > 7 && BN <= FD + 3 && BN <= 63);
  using Product = IntegerFor<BN + FD / 2 + 2>;
  const std::int64_t sign = shift_right_floor(std::int64_t{n.raw()}, 63);
  const std::int64_t raw = (n.raw() ^ sign) - sign;  // branchless: the sign is unpredictable
  const auto excess = wrapping_subtract<std::int64_t>(d.raw(), std::int64_t{1} << FD);
  DETENT_ASSERT(detail::is_within<FD / 2 + 2>(excess));
  const auto quotient = raw - integer_cast<std::int64_t>(shift_right_floor(
                                  wrapping_multiply<Product>(raw, excess), FD + 1));
  constexpr std::int64_t margin = 1 << 6;
  const std::int64_t above = shift_right_floor(quotient + margin, shift);
  if (above == shift_right_floor(quotient - margin, shift)) return detail::clamp_raw<T>(above);
  using Candidate = Fixed<BN - shift + 1, T::frac>;
  const auto candidate = Candidate::assume_raw(static_cast<typename Candidate::raw_type>(above));
  const bool is_reached = narrow_product<2 * BN>(square(candidate), d) <= square(n);
  return detail::clamp_raw<T>(above - (is_reached ? 0 : 1));
}

}  // namespace detent
