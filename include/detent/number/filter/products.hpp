// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

#include "detent/number/filter/leading.hpp"
#include "detent/number/rounding.hpp"

namespace detent {

namespace detail {

/// The high word of the product of two numbers' leading words, halved: less than 2 too small.
template <int Bits1, int Frac1, int Bits2, int Frac2>
[[nodiscard]] constexpr LeadingWord leading_product(const Fixed<Bits1, Frac1>& a,
                                                    const Fixed<Bits2, Frac2>& b) noexcept {
  const auto x = leading_word(a.raw()), y = leading_word(b.raw());
  return {multiply_words(x.word, y.word).high >> 1, x.exponent + y.exponent - Frac1 - Frac2};
}

}  // namespace detail

/// The sign of a b - c d, for non-negative numbers.
///
/// Filter for products wider than 128 bits: their leading words decide unless they are almost
/// equal. Then the exact products decide.
template <Number A, Number B, Number C, Number D>
[[nodiscard]] constexpr int compare_products(const A& a, const B& b, const C& c,
                                             const D& d) noexcept {
  if constexpr (127 < bits_of<A> + bits_of<B> || 127 < bits_of<C> + bits_of<D>) {
    const auto left = detail::leading_product(a, b), right = detail::leading_product(c, d);
    const int excess = left.exponent - right.exponent;
    const auto x = static_cast<std::int64_t>(left.word >> std::clamp(-excess, 0, 63));
    const auto y = static_cast<std::int64_t>(right.word >> std::clamp(excess, 0, 63));
    if (x - y >= 2) return 1;  // each is still less than 2 too small
    if (y - x >= 2) return -1;
  }
  const auto left = a * b;
  const auto right = c * d;
  return (left > right) - (left < right);
}

}  // namespace detent
