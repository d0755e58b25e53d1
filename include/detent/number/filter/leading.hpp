// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>

#include "detent/number/integer.hpp"

namespace detent::detail {

// The leading 64 bits of integers, which decide most comparisons and quotients.

/// Of x >= 0: word * 2^exponent <= x < (word + 1) * 2^exponent. The top bit of the word is set
/// unless x is 0.
struct LeadingWord {
  std::uint64_t word;
  int exponent;
};

template <class Int>
[[nodiscard]] constexpr LeadingWord leading_word(const Int& x) noexcept {
  if constexpr (words_of<Int> == 1) {
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

/// floor(x / 2^(length - 64)) for 0 <= x < 2^length.
template <class Int>
[[nodiscard]] constexpr std::uint64_t leading_word(const Int& x, int length) noexcept {
  if constexpr (words_of<Int> == 1) {
    return static_cast<std::uint64_t>(x) << (64 - length);
  } else {
    constexpr int words = words_of<Int>;
    return Wide<words>(shift_left(x, 64 * words - length)).word(words - 1);
  }
}

/// 2^126 / x for x >= 2^63, rounded down to within 2^-58 of it.
///
/// A division by one more than the leading half of x gives 33 bits, less than 2^-31 + 2^-32 too
/// small. A Newton step with the known error squares it and stays below.
[[nodiscard]] constexpr std::uint64_t reciprocal(std::uint64_t x) noexcept {
  const std::uint64_t rough = ~std::uint64_t{0} / ((x >> 32) + 1);
  constexpr std::uint64_t below_one = (std::uint64_t{1} << 62) - 1;
  const std::uint64_t missing = below_one - multiply_words(x, rough << 30).high;
  return (rough << 30) + ((rough * (missing >> 2)) >> 30);
}

}  // namespace detent::detail
