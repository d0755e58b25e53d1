// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "detent/number/rounding.hpp"

namespace detent {

namespace detail {

/// x >= 0 as word * 2^exponent and less than 2^exponent more, where the top bit of the word is set
/// unless x is 0.
struct LeadingWord {
  std::uint64_t word;
  int exponent;
};

template <class I>
[[nodiscard]] constexpr LeadingWord leading_word(const I& x) noexcept {
  if constexpr (words_of<I> == 1) {
    const auto word = static_cast<std::uint64_t>(static_cast<std::int64_t>(x));
    const int scale = std::countl_zero(word) & 63;
    return {word << scale, -scale};
  } else {
    const int exponent = positive_bit_length(x) - 64;
    return {integer_cast<std::uint64_t>(exponent < 0 ? shift_left(x, -exponent & 63)
                                                     : shift_right_floor(x, exponent)),
            exponent};
  }
}

/// The high word of the product of two numbers' leading words, halved: less than 2 too small.
template <int B1, int F1, int B2, int F2>
[[nodiscard]] constexpr LeadingWord leading_product(const Fixed<B1, F1>& a,
                                                    const Fixed<B2, F2>& b) noexcept {
  const auto x = leading_word(a.raw()), y = leading_word(b.raw());
  return {multiply_words(x.word, y.word).high >> 1, x.exponent + y.exponent - F1 - F2};
}

}  // namespace detail

/// The sign of a b - c d, for numbers of which none is negative.
///
/// The leading words of products that are wider than 128 bits decide, unless they are almost equal:
/// then, the products do.
template <Number A, Number B, Number C, Number D>
[[nodiscard]] constexpr int compare_products(const A& a, const B& b, const C& c,
                                             const D& d) noexcept {
  if constexpr (bits_of<A> + bits_of < B >> 127 || bits_of<C> + bits_of < D >> 127) {
    const auto left = detail::leading_product(a, b), right = detail::leading_product(c, d);
    const int excess = left.exponent - right.exponent;
    const auto x = static_cast<std::int64_t>(left.word >> std::clamp(-excess, 0, 63));
    const auto y = static_cast<std::int64_t>(right.word >> std::clamp(excess, 0, 63));
    if (x - y >= 2) return 1;  // either is still less than 2 too small
    if (y - x >= 2) return -1;
  }
  const auto left = a * b;
  const auto right = c * d;
  return (left > right) - (left < right);
}

}  // namespace detent
