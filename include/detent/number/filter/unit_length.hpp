// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "detent/number/filter/filtered.hpp"
#include "detent/number/fraction.hpp"

namespace detent {

// Quotients by the length of a direction or its square, which are 1 within 2^-28, or 2^-12 in 16
// bits: a series replaces the division.

/// n / d for n >= 0 and d > 0, rounded down to the grid of `T`, which is no finer than n's, and
/// clamped; fast if d is within 2^-28 of 1. The exact n must not be above its value. If unsure, the
/// result is `value` or the step below it.
///
/// For d = 1 + e the quotient is n (1 - e + e^2 - ...). So n - n e on the grid of T is at most a
/// few steps off. The remainder is small enough to be computed modulo 2^64 and gives the number of
/// steps. The filter is sure if the remainder is not less than the error of n.
template <class T, int BN, int FN, int BD, int FD>
[[nodiscard]] constexpr Decided<T> decide_quotient_floor(const Approximate<Fixed<BN, FN>>& n,
                                                         const Fixed<BD, FD>& d) noexcept {
  using Grid = detail::GridQuotient<T, Fixed<BN, FN>, Fixed<BD, FD>>;
  using Integer = typename Grid::Integer;
  constexpr int shift = Grid::shift;  // numerator * 2^shift / denominator is the quotient
  static_assert(shift >= 0 && FD >= shift);
  if constexpr (value_bits < Integer >> 63 && BN <= 63 && FD > 28 && FD <= 60 && BD <= 63) {
    constexpr std::int64_t one = std::int64_t{1} << FD;
    const auto excess = integer_cast<std::int64_t>(wrapping_subtract<std::int64_t>(d.raw(), one));
    constexpr std::int64_t tolerance = std::int64_t{1} << (FD - 28);
    if (-tolerance <= excess && excess <= tolerance) {
      const auto numerator = integer_cast<std::int64_t>(n.value.raw());
      const std::int64_t whole = shift_right_floor(numerator, FD - shift);
      // |whole excess| < 2^(63 - 30) * 2^32; rounded to nearest, so that small ones vanish.
      const auto correction = integer_cast<std::int64_t>(shift_right_floor(
          wrapping_add<Int128>(wrapping_multiply<Int128>(whole, excess), one / 2), FD));
      std::int64_t quotient = whole - correction;
      auto rest = wrapping_subtract<std::int64_t>(
          shift_left(numerator, shift), wrapping_multiply<std::int64_t>(quotient, d.raw()));
      for (; rest < 0; rest += d.raw()) --quotient;
      for (; rest >= d.raw(); rest -= d.raw()) ++quotient;
      return {detail::clamp_raw<T>(quotient), shift_right_floor(rest, shift) >= n.error.raw()};
    }
  }
  Integer divisor;
  const auto [quotient, rest] = Grid::divide(n.value, d, divisor);
  return {detail::clamp_raw<T>(quotient),
          shift_right_floor(rest, shift) >= integer_cast<Integer>(n.error.raw())};
}

/// n / d rounded to nearest on the grid of `T` for |n| <= d, where d is the squared length of a
/// direction or a unit quaternion: n (1 - e) for d = 1 + e (docs/filters.md, lemma 42). Unsure for
/// any other d.
template <class T, int BN, int BD, int F>
[[nodiscard]] constexpr Decided<T> decide_unit_quotient(const Fixed<BN, F>& n,
                                                        const Fixed<BD, F>& d) noexcept {
  static_assert(F % 2 == 0 && 28 <= F && F <= 60 && BN <= F + 1 && BD <= F + 1);
  constexpr std::int64_t tolerance = (std::int64_t{1} << (F / 2 + 2)) + 4;
  const std::int64_t numerator{n.raw()};
  const std::int64_t excess = std::int64_t{d.raw()} - (std::int64_t{1} << F);
  const auto correction = shift_right_floor(
      wrapping_multiply<std::int64_t>(shift_right_floor(numerator, F / 2), excess), F / 2);
  const auto quotient = Fixed<63, F>::assume_raw(numerator - correction);
  auto nearest = decide_nearest<T>(Approximate{quotient, Steps<22>()});
  nearest.is_sure &= -tolerance <= excess && excess <= tolerance;
  return nearest;
}

/// |n| / sqrt(d), rounded down to the grid of `T` and clamped, where d is the squared length of a
/// direction.
///
/// 1 / sqrt(1 + e) = 1 - e / 2 + ...: the rest of the series is below 3 e^2 / 8, which is less than
/// 2^6 steps of n. The squares are compared only if that might cross a step of T.
template <class T, int BN, int FN, int BD, int FD>
requires(BN <= 63) [[nodiscard]] constexpr T
    divide_by_length(const Fixed<BN, FN>& n, const Fixed<BD, FD>& d) noexcept {
  constexpr int shift = FN - T::frac;
  static_assert(shift > 7 && BN <= FD + 3 && BN <= 63);
  using Product = IntegerFor<BN + FD / 2 + 2>;
  using Quotient = Fixed<63, FN>;
  using Candidate = Fixed<BN - shift + 1, T::frac>;
  const std::int64_t sign = shift_right_floor(std::int64_t{n.raw()}, 63);
  const std::int64_t raw = (n.raw() ^ sign) - sign;  // branchless: the sign is unpredictable
  const auto excess = wrapping_subtract<std::int64_t>(d.raw(), std::int64_t{1} << FD);
  DETENT_ASSERT(detail::is_within<FD / 2 + 2>(excess));
  const auto quotient =
      Quotient::assume_raw(raw - integer_cast<std::int64_t>(shift_right_floor(
                                     wrapping_multiply<Product>(raw, excess), FD + 1)));
  const auto floor = decide_floor<Candidate>(Approximate{quotient, Steps<64>()});
  const auto exact = [&](const Candidate& above) {
    const bool is_reached = narrow_product<2 * BN>(square(above), d) <= square(n);
    using Raw = typename Candidate::raw_type;
    return Candidate::assume_raw(static_cast<Raw>(above.raw() - (is_reached ? 0 : 1)));
  };
  return detail::clamp_raw<T>(or_exact(floor, exact).raw());
}

/// The same for a long n: of its leading bits, if the step that they drop does not matter.
template <class T, int BN, int FN, int BD, int FD>
requires(BN > 63) [[nodiscard]] constexpr T
    divide_by_length(const Fixed<BN, FN>& n, const Fixed<BD, FD>& d) noexcept {
  constexpr int dropped = BN - 62;
  using Quotient = Fixed<63, FN - dropped>;
  static_assert(Quotient::frac - T::frac > 8 && FD == 60);
  if (n == 0) return T();
  if constexpr (has_filters) {
    const auto raw = integer_cast<std::int64_t>(shift_right_floor(abs(n).raw(), dropped));
    const auto excess = wrapping_subtract<std::int64_t>(d.raw(), std::int64_t{1} << FD);
    const auto quotient =
        Quotient::assume_raw(raw - integer_cast<std::int64_t>(shift_right_floor(
                                       wrapping_multiply<Int128>(raw, excess), FD + 1)));
    const auto floor = decide_floor<Fixed<62 - Quotient::frac + T::frac + 1, T::frac>>(
        Approximate{quotient, Steps<66>()});
    if (floor.is_sure) return floor_to<T>(floor.value);
  }
  return sqrt_floor<T>(Fraction{square(n), d});
}

}  // namespace detent
