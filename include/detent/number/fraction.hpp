// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>

#include "detent/number/next_up.hpp"
#include "detent/number/rounding.hpp"

namespace detent {

/// An undivided quotient: signs and comparisons need no division, and most rays miss. The
/// denominator is positive.
template <Number N, Number D>
struct Fraction {
  N numerator;
  D denominator;
};

template <Number N, Number D>
Fraction(N, D) -> Fraction<N, D>;

/// numerator / denominator, for a denominator of either sign except 0.
template <Number N, Number D>
[[nodiscard]] constexpr Fraction<N, D> make_fraction(const N& numerator,
                                                     const D& denominator) noexcept {
  if (denominator < 0) {
    return {narrow_negative(numerator), narrow_negative(denominator)};
  }
  return {numerator, denominator};
}

/// Whether the value of a fraction is at most `x`, exactly.
template <Number N, Number D, Number T>
[[nodiscard]] constexpr bool operator<=(const Fraction<N, D>& fraction, const T& x) noexcept {
  return fraction.numerator <= x * fraction.denominator;
}

namespace detail {

/// Quotient and remainder of a fraction's raw numbers: value * 2^(D::frac - N::frac).
template <class N, class D>
constexpr auto divide_raw(const Fraction<N, D>& x) noexcept {
  using Integer = IntegerFor<(std::max)(N::bits, D::bits)>;
  return divide_floor(integer_cast<Integer>(x.numerator.raw()),
                      integer_cast<Integer>(x.denominator.raw()));
}

}  // namespace detail

/// Whether one fraction is less than another, exactly.
///
/// Compares the whole parts, then, if they are equal, the remainders over their denominators. So no
/// product is wider than both denominators together, however wide the numerators are.
template <Number N1, Number D1, Number N2, Number D2>
[[nodiscard]] constexpr bool operator<(const Fraction<N1, D1>& a,
                                       const Fraction<N2, D2>& b) noexcept {
  if constexpr (!is_fixed<N1>) {
    return a.numerator * b.denominator < b.numerator * a.denominator;
  } else {
    static_assert(N1::frac - D1::frac == N2::frac - D2::frac);
    const auto left = detail::divide_raw(a);
    const auto right = detail::divide_raw(b);
    using Whole = IntegerFor<(std::max)({N1::bits, D1::bits, N2::bits, D2::bits})>;
    const auto whole_left = integer_cast<Whole>(left.quotient);
    const auto whole_right = integer_cast<Whole>(right.quotient);
    if (whole_left != whole_right) return whole_left < whole_right;
    using Product = IntegerFor<detail::result_bits(D1::bits + D2::bits)>;
    const auto rest = [](const auto& remainder, const auto& denominator) {
      return wrapping_multiply<Product>(integer_cast<Product>(remainder), denominator.raw());
    };
    return rest(left.remainder, b.denominator) < rest(right.remainder, a.denominator);
  }
}

/// The square root of a non-negative fraction, rounded down to the grid of `T` and clamped.
///
/// Rounding the quotient down to the grid of the squares first is harmless: floor(sqrt(floor(y)))
/// is floor(sqrt(y)).
template <Number T, Number N, Number D>
[[nodiscard]] constexpr T sqrt_floor(const Fraction<N, D>& x) noexcept {
  if constexpr (!is_fixed<T>) {
    return sqrt_floor<T>(x.numerator / x.denominator);
  } else {
    using Square = Fixed<2 * T::bits + 1, 2 * T::frac>;  // one bit more than T can hold: it clamps
    return sqrt_floor<T>(quotient_floor<Square>(x.numerator, x.denominator));
  }
}

/// The square root of a non-negative fraction, rounded up to the grid of `T` and clamped.
template <Number T, Number N, Number D>
[[nodiscard]] constexpr T sqrt_ceil(const Fraction<N, D>& x) noexcept {
  const auto root = sqrt_floor<T>(x);
  if constexpr (!is_fixed<T>) {
    return root;
  } else {
    return x <= square(root) ? root : next_up(root);
  }
}

/// The value of a fraction that is known to be in [0, T::max()], rounded down to the grid of `T`.
template <Number T, Number N, Number D>
[[nodiscard]] constexpr T narrow_floor(const Fraction<N, D>& x) noexcept {
  if constexpr (!is_fixed<T>) {
    return x.numerator / x.denominator;
  } else {
    constexpr int shift = T::frac - N::frac + D::frac;
    static_assert(shift >= 0 && T::bits <= 31);
    // numerator * 2^shift <= T::max() * denominator on the grid of T, so it fits the same bits.
    using Integer = IntegerFor<(std::max)(T::bits + D::bits, 31)>;
    const auto numerator = shift_left(integer_cast<Integer>(x.numerator.raw()), shift);
    return T::assume_raw(
        static_cast<typename T::raw_type>(short_quotient(numerator, x.denominator.raw())));
  }
}

/// The value of a non-negative fraction rounded down to the grid of `T`, or nothing if the exact
/// value is greater than `limit`.
template <Number T, Number N, Number D>
[[nodiscard]] constexpr std::optional<T> floor_within(const Fraction<N, D>& x,
                                                      const T& limit) noexcept {
  if constexpr (!is_fixed<T>) {
    const T value = x.numerator / x.denominator;
    if (value > limit) return std::nullopt;
    return value;
  } else {
    // |limit| * denominator needs T::bits + D::bits bits: for 127 of them -2^127 still fits.
    constexpr int bits = T::bits + D::bits;
    if (x.numerator > narrow_product<bits>(limit, x.denominator)) return std::nullopt;
    return narrow_floor<T>(x);
  }
}

}  // namespace detent
