// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>

#include "detent/number/rounding.hpp"

namespace detent {

/// A quotient that is not divided yet: signs and comparisons need no division, and most rays miss.
/// The denominator is positive.
template <Number N, Number D>
struct Fraction {
  N numerator;
  D denominator;
};

/// numerator / denominator for a denominator of either sign but 0.
template <Number N, Number D>
[[nodiscard]] constexpr Fraction<N, D> make_fraction(const N& numerator,
                                                     const D& denominator) noexcept {
  if (denominator < 0) {
    return {narrow<bits_of<N>>(-numerator), narrow<bits_of<D>>(-denominator)};
  }
  return {numerator, denominator};
}

/// The value of a non-negative fraction rounded down to the grid of `T`, or nothing when the exact
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
    constexpr int shift = T::frac - N::frac + D::frac;
    static_assert(shift >= 0);
    // numerator * 2^shift <= limit * denominator on the grid of T, so it fits the same bits.
    using Integer = IntegerFor<std::max(bits, 31)>;
    const auto numerator = shift_left(integer_cast<Integer>(x.numerator.raw()), shift);
    const auto denominator = integer_cast<Integer>(x.denominator.raw());
    return T::assume_raw(
        integer_cast<typename T::raw_type>(divide_floor(numerator, denominator).quotient));
  }
}

}  // namespace detent
