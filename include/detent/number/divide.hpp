// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "detent/number/integer.hpp"

namespace detent {

template <class Int>
struct Division {
  Int quotient;
  Int remainder;
};

namespace detail {

/// Long division of non-negative integers in base 2^32.
///
/// source: Knuth, The Art of Computer Programming 2, 4.3.1, algorithm D
template <int Words>
constexpr Division<Wide<Words>> divide_long(const Wide<Words>& numerator,
                                            const Wide<Words>& denominator) noexcept {
  constexpr int digits = 2 * Words;
  using Digits = std::array<std::uint32_t, std::size_t{digits + 1}>;
  const auto at = [](auto& array, int i) -> auto& { return array[static_cast<std::size_t>(i)]; };
  const auto split = [&at](const Wide<Words>& x) {
    Digits result{};
    for (int i = 0; i < digits; ++i) {
      at(result, i) = static_cast<std::uint32_t>(x.word(i / 2) >> (32 * (i % 2)));
    }
    return result;
  };
  const auto join = [&at](const Digits& x) {
    std::array<std::uint64_t, std::size_t{Words}> words{};
    for (int i = 0; i < digits; ++i) {
      at(words, i / 2) |= std::uint64_t{at(x, i)} << (32 * (i % 2));
    }
    return Wide<Words>::from_words(words);
  };

  const int length = (bit_length(denominator) + 31) / 32;
  const int scale = 32 * length - bit_length(denominator);  // makes the leading digit >= 2^31
  const Digits v = split(denominator << scale);
  Digits u = split(numerator << scale);
  // The numerator is non-negative, so its top bit is 0. Receives the bits that the scale shifts
  // out.
  if (scale > 0)
    at(u, digits) = static_cast<std::uint32_t>(numerator.word(Words - 1) >> (64 - scale));

  Digits q{};
  for (int j = digits - length; j >= 0; --j) {
    const std::uint64_t leading = (std::uint64_t{at(u, j + length)} << 32) | at(u, j + length - 1);
    const std::uint64_t divisor = at(v, length - 1);
    std::uint64_t digit = leading / divisor;
    std::uint64_t rest = leading % divisor;
    const std::uint64_t second = length > 1 ? at(v, length - 2) : 0;
    const std::uint64_t third = length > 1 ? at(u, j + length - 2) : 0;
    while ((digit >> 32) != 0 || digit * second > ((rest << 32) | third)) {
      --digit;
      rest += divisor;
      if ((rest >> 32) != 0) break;
    }
    std::uint64_t carry = 0;
    std::uint64_t borrow = 0;
    for (int i = 0; i < length; ++i) {
      carry += digit * at(v, i);
      const std::uint64_t difference =
          std::uint64_t{at(u, i + j)} - static_cast<std::uint32_t>(carry) - borrow;
      at(u, i + j) = static_cast<std::uint32_t>(difference);
      borrow = difference >> 63;
      carry >>= 32;
    }
    const std::uint64_t difference = std::uint64_t{at(u, j + length)} - carry - borrow;
    at(u, j + length) = static_cast<std::uint32_t>(difference);
    if ((difference >> 63) != 0) {  // the digit was one too large
      --digit;
      std::uint64_t sum = 0;
      for (int i = 0; i < length; ++i) {
        sum += std::uint64_t{at(u, i + j)} + at(v, i);
        at(u, i + j) = static_cast<std::uint32_t>(sum);
        sum >>= 32;
      }
      at(u, j + length) += static_cast<std::uint32_t>(sum);
    }
    at(q, j) = static_cast<std::uint32_t>(digit);
  }
  for (int i = 0; scale > 0 && i < digits; ++i) {
    at(u, i) = (at(u, i) >> scale) | (at(u, i + 1) << (32 - scale));
  }
  return {join(q), join(u)};
}

/// (high * 2^64 + low) / d and the remainder, for d > high.
[[nodiscard]] constexpr WordDivision<std::uint64_t> divide_word(std::uint64_t high,
                                                                std::uint64_t low,
                                                                std::uint64_t d) noexcept {
  const int scale = std::countl_zero(d);
  const std::uint64_t scaled_high = scale == 0 ? high : (high << scale) | (low >> (64 - scale));
  const auto division = divide_double_word(scaled_high, low << scale, d << scale);
  return {division.quotient, division.remainder >> scale};
}

/// `divide_long` of two words, without arrays of digits; denominator > 0.
///
/// source: Hacker's Delight, 9-5, udivdi3: the quotient estimated from the leading word of the
///         denominator is right or one too large, so the estimate minus one needs at most one
///         correction.
[[nodiscard]] constexpr Division<Wide<2>> divide_two_words(const Wide<2>& numerator,
                                                           const Wide<2>& denominator) noexcept {
  const std::uint64_t high = numerator.word(1), low = numerator.word(0);
  const std::uint64_t d1 = denominator.word(1), d0 = denominator.word(0);
  if (d1 == 0) {
    const auto division = divide_word(high % d0, low, d0);
    return {Wide<2>::from_words({division.quotient, high / d0}),
            Wide<2>::from_words({division.remainder, 0})};
  }
  const int scale = std::countl_zero(d1);  // at least 1
  const std::uint64_t leading = (d1 << scale) | (d0 >> (64 - scale));
  std::uint64_t quotient =
      divide_word(high >> 1, (high << 63) | (low >> 1), leading).quotient >> (63 - scale);
  if (quotient != 0) --quotient;
  auto [product, carry] = multiply_words(quotient, d0);
  carry += quotient * d1;
  std::uint64_t rest1 = high - carry - (low < product ? 1u : 0u), rest0 = low - product;
  if (rest1 > d1 || (rest1 == d1 && rest0 >= d0)) {
    ++quotient;
    rest1 = rest1 - d1 - (rest0 < d0 ? 1u : 0u);
    rest0 -= d0;
  }
  return {Wide<2>::from_words({quotient, 0}), Wide<2>::from_words({rest0, rest1})};
}

/// The low word of x / 2^dropped, for x >= 0.
template <class Int>
[[nodiscard]] constexpr std::uint64_t word_above(const Int& x, int dropped) noexcept {
  if constexpr (is_wide<Int>) {
    const int at = dropped / 64, bits = dropped % 64;
    const std::uint64_t low = x.word(at) >> bits;
    return bits == 0 || at + 1 == words_of<Int> ? low : low | (x.word(at + 1) << (64 - bits));
  } else {
    return integer_cast<std::uint64_t>(shift_right_floor(x, dropped));
  }
}

}  // namespace detail

/// floor(numerator / denominator) and the remainder; `denominator` > 0.
template <class Int>
[[nodiscard]] constexpr Division<Int> divide_floor(const Int& numerator,
                                                   const Int& denominator) noexcept {
  Int quotient, remainder;
  if constexpr (detail::is_wide<Int>) {
    const bool negative = numerator.is_negative();
    const Int magnitude = negative ? -numerator : numerator;
    const int length = (std::max)(bit_length(magnitude), bit_length(denominator));
    if (length <= 63) {
      quotient = Int(magnitude.word(0) / denominator.word(0));
      remainder = Int(magnitude.word(0) % denominator.word(0));
    } else if (detail::words_of<Int> > 2 && length <= 127) {
      const auto division =
          divide_floor(integer_cast<Int128>(magnitude), integer_cast<Int128>(denominator));
      quotient = integer_cast<Int>(division.quotient);
      remainder = integer_cast<Int>(division.remainder);
    } else if constexpr (detail::words_of<Int> == 2 && !DETENT_SHORT_WORDS) {
      const auto division = detail::divide_two_words(magnitude, denominator);
      quotient = division.quotient;
      remainder = division.remainder;
    } else {
      const auto division = detail::divide_long(magnitude, denominator);
      quotient = division.quotient;
      remainder = division.remainder;
    }
    if (negative) {
      quotient = -quotient;
      remainder = -remainder;
    }
  } else {
    quotient = static_cast<Int>(numerator / denominator);
    remainder = static_cast<Int>(numerator % denominator);
  }
  if (is_negative(remainder)) {
    quotient = static_cast<Int>(quotient - Int(1));
    remainder = static_cast<Int>(remainder + denominator);
  }
  return {quotient, remainder};
}

/// floor(numerator / denominator) for numerator >= 0, denominator > 0 and a quotient below 2^32;
/// the denominator's type may be narrower.
///
/// Let d be the leading 32 bits of the denominator, and n the numerator without as many low bits.
/// Then q = floor(n / (d + 1)) is too small by at most 4. It is correct if n - q d leaves room for
/// the dropped bits.
template <class N, class D>
[[nodiscard]] constexpr std::int64_t short_quotient(const N& numerator,
                                                    const D& denominator) noexcept {
  if constexpr (value_bits<N> <= 63) {
    return integer_cast<std::int64_t>(numerator) / integer_cast<std::int64_t>(denominator);
  } else {
    const int dropped = (std::max)(positive_bit_length(denominator) - 32, 0);
    const std::uint64_t n = detail::word_above(numerator, dropped);
    const std::uint64_t d = detail::word_above(denominator, dropped);
    if (dropped == 0) return static_cast<std::int64_t>(n / d);
    std::uint64_t first = n >> 32, left = n & 0xffffffff;  // divided by 2^32
    if (d != 0xffffffff) {
      const auto division = divide_halves(n, static_cast<std::uint32_t>(d + 1));
      first = division.quotient;
      left = division.remainder;
    }
    auto quotient = static_cast<std::int64_t>(first);
    if (left + first < d) return quotient;
    auto rest = wrapping_subtract<N>(numerator, wrapping_multiply<N>(denominator, quotient));
    for (; rest >= integer_cast<N>(denominator); rest = wrapping_subtract<N>(rest, denominator)) {
      ++quotient;
    }
    return quotient;
  }
}

}  // namespace detent
