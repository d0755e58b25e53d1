// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "detent/number/short_words.hpp"

// Define DETENT_PORTABLE_INT128 to 1 to use the library's 128-bit integer even if the compiler has
// one. It changes speed, never a result. clang-cl has one, but Microsoft's runtime library lacks
// its division functions.
#ifndef DETENT_PORTABLE_INT128
#define DETENT_PORTABLE_INT128 0
#endif
// DETENT_NATIVE_INT128 is 1 if 128-bit integers are the compiler's.
#if defined(__SIZEOF_INT128__) && !defined(_MSC_VER) && !DETENT_PORTABLE_INT128
#define DETENT_NATIVE_INT128 1
#else
#define DETENT_NATIVE_INT128 0
#endif

namespace detent {

template <int Words>
class Wide;

#if DETENT_NATIVE_INT128
__extension__ typedef __int128 Int128;
__extension__ typedef unsigned __int128 UInt128;
#else
using Int128 = Wide<2>;
#endif

/// The exact product of two 64-bit words, from 32-bit halves.
[[nodiscard]] constexpr WordProduct multiply_words_portable(std::uint64_t a,
                                                            std::uint64_t b) noexcept {
  const std::uint64_t a0 = static_cast<std::uint32_t>(a), a1 = a >> 32;
  const std::uint64_t b0 = static_cast<std::uint32_t>(b), b1 = b >> 32;
  const std::uint64_t low = a0 * b0;
  const std::uint64_t middle = a1 * b0 + (low >> 32);  // at most (2^32 - 1) * 2^32
  const std::uint64_t cross = a0 * b1 + static_cast<std::uint32_t>(middle);
  return {(cross << 32) | static_cast<std::uint32_t>(low),
          a1 * b1 + (middle >> 32) + (cross >> 32)};
}

/// The exact product of two 64-bit words.
[[nodiscard]] constexpr WordProduct multiply_words(std::uint64_t a, std::uint64_t b) noexcept {
#if DETENT_NATIVE_INT128
  const UInt128 product = static_cast<UInt128>(a) * b;
  return {static_cast<std::uint64_t>(product), static_cast<std::uint64_t>(product >> 64)};
#else
  if constexpr (has_short_products) {
    const auto a0 = static_cast<std::uint32_t>(a), a1 = static_cast<std::uint32_t>(a >> 32);
    const auto b0 = static_cast<std::uint32_t>(b), b1 = static_cast<std::uint32_t>(b >> 32);
    const std::uint64_t low = multiply_halves(a0, b0);
    const std::uint64_t middle = multiply_halves(a1, b0) + (low >> 32);
    const std::uint64_t cross = multiply_halves(a0, b1) + static_cast<std::uint32_t>(middle);
    return {(cross << 32) | static_cast<std::uint32_t>(low),
            multiply_halves(a1, b1) + (middle >> 32) + (cross >> 32)};
  } else {
    return multiply_words_portable(a, b);
  }
#endif
}

/// The product of integers of any widths modulo 2^(64 * Result): exact when Result is A + B.
template <int Result, int A, int B>
[[nodiscard]] constexpr Wide<Result> multiply(const Wide<A>& a, const Wide<B>& b) noexcept;

/// A signed integer of `Words` 64-bit words in two's complement. Arithmetic is modulo
/// 2^(64 * Words), as for built-in unsigned integers.
///
/// `Fixed` tracks the bits; this class only computes. Words run from low to high.
template <int Words>
class Wide {
  static_assert(Words >= 2, "detent: one word is a std::int64_t");

 public:
  constexpr Wide() noexcept = default;

  /// Sign-extends (or, from an unsigned type, zero-extends) a built-in integer.
  template <std::integral Int>
  constexpr Wide(Int value) noexcept {
    words_[0] = static_cast<std::uint64_t>(value);
    if constexpr (sizeof(Int) > sizeof(std::uint64_t)) {
      words_[1] = static_cast<std::uint64_t>(value >> 64);
      fill_from(2, value < 0);
    } else if constexpr (Words == 2 && std::is_signed_v<Int>) {
      // cppcheck-suppress shiftTooManyBitsSigned  // defined in C++20: the sign
      words_[1] = static_cast<std::uint64_t>(static_cast<std::int64_t>(value) >> 63);
    } else {
      fill_from(1, std::is_signed_v<Int> && value < 0);
    }
  }
#if DETENT_NATIVE_INT128
  constexpr Wide(Int128 value) noexcept {
    words_[0] = static_cast<std::uint64_t>(value);
    words_[1] = static_cast<std::uint64_t>(value >> 64);
    fill_from(2, value < 0);
  }
#endif

  /// Sign-extends a narrower integer; keeps the low words of a wider one.
  template <int Other>
  requires(Other != Words) constexpr explicit Wide(const Wide<Other>& other) noexcept {
    for (int i = 0; i < Words && i < Other; ++i) words_[index(i)] = other.word(i);
    fill_from(Other, other.is_negative());
  }

  [[nodiscard]] static constexpr Wide from_words(
      const std::array<std::uint64_t, std::size_t{Words}>& words) noexcept {
    Wide result;
    result.words_ = words;
    return result;
  }

  /// Word `i`, counted from the low end.
  [[nodiscard]] DETENT_INLINE_TINY constexpr std::uint64_t word(int i) const noexcept {
    return words_[index(i)];
  }
  [[nodiscard]] constexpr bool is_negative() const noexcept { return (words_.back() >> 63) != 0; }
#if DETENT_NATIVE_INT128
  /// Words 2 i and 2 i + 1.
  [[nodiscard]] DETENT_INLINE_TINY constexpr UInt128 pair(int i) const noexcept {
    return (static_cast<UInt128>(word(2 * i + 1)) << 64) | word(2 * i);
  }
  /// high * 2^128 + low, whose sign is that of `high`.
  [[nodiscard]] DETENT_INLINE_TINY static constexpr Wide from_pairs(UInt128 low,
                                                                    UInt128 high) noexcept {
    static_assert(Words >= 4);
    Wide result;
    result.words_[0] = static_cast<std::uint64_t>(low);
    result.words_[1] = static_cast<std::uint64_t>(low >> 64);
    result.words_[2] = static_cast<std::uint64_t>(high);
    result.words_[3] = static_cast<std::uint64_t>(high >> 64);
    result.fill_from(4, (high >> 127) != 0);
    return result;
  }
#endif

  /// The low bits, as in a conversion between built-in integers.
  template <std::integral Int>
  [[nodiscard]] explicit constexpr operator Int() const noexcept {
    if constexpr (sizeof(Int) > sizeof(std::uint64_t)) {
      return static_cast<Int>(words_[0]) | static_cast<Int>(static_cast<Int>(words_[1]) << 64);
    } else {
      return static_cast<Int>(words_[0]);
    }
  }
#if DETENT_NATIVE_INT128
  [[nodiscard]] explicit constexpr operator Int128() const noexcept {
    return static_cast<Int128>((static_cast<UInt128>(words_[1]) << 64) | words_[0]);
  }
#endif

  [[nodiscard]] DETENT_INLINE_WHEN_SHORT friend constexpr Wide operator+(const Wide& a,
                                                                         const Wide& b) noexcept {
    if constexpr (Words == 2) {  // the loop unrolled, to stay in registers
      const std::uint64_t low = a.word(0) + b.word(0);
      return from_words({low, a.word(1) + b.word(1) + (low < b.word(0) ? 1u : 0u)});
    }
#if DETENT_NATIVE_INT128
    if constexpr (Words == 4) {  // compilers have instructions for the carry of a pair
      const UInt128 low = a.pair(0) + b.pair(0);
      return from_pairs(low, a.pair(1) + b.pair(1) + (low < b.pair(0) ? 1u : 0u));
    }
#endif
    Wide sum;
    std::uint64_t carry = 0;
    for (int i = 0; i < Words; ++i) {
      const std::uint64_t partial = a.word(i) + carry;
      carry = partial < carry ? 1u : 0u;
      sum.words_[index(i)] = partial + b.word(i);
      carry += sum.word(i) < partial ? 1u : 0u;
    }
    return sum;
  }

  [[nodiscard]] DETENT_INLINE_WHEN_SHORT friend constexpr Wide operator-(const Wide& a,
                                                                         const Wide& b) noexcept {
    if constexpr (Words == 2) {
      const std::uint64_t borrow = a.word(0) < b.word(0) ? 1u : 0u;
      return from_words({a.word(0) - b.word(0), a.word(1) - b.word(1) - borrow});
    }
#if DETENT_NATIVE_INT128
    if constexpr (Words == 4) {
      const UInt128 borrow = a.pair(0) < b.pair(0) ? 1u : 0u;
      return from_pairs(a.pair(0) - b.pair(0), a.pair(1) - b.pair(1) - borrow);
    }
#endif
    Wide difference;
    std::uint64_t borrow = 0;
    for (int i = 0; i < Words; ++i) {
      const std::uint64_t partial = a.word(i) - borrow;
      borrow = partial > a.word(i) ? 1u : 0u;
      difference.words_[index(i)] = partial - b.word(i);
      borrow += difference.word(i) > partial ? 1u : 0u;
    }
    return difference;
  }

  [[nodiscard]] DETENT_INLINE_WHEN_SHORT friend constexpr Wide operator-(const Wide& a) noexcept {
    return Wide() - a;
  }

  [[nodiscard]] friend constexpr Wide operator*(const Wide& a, const Wide& b) noexcept {
    return multiply<Words>(a, b);
  }

  /// `count` in [0, 64 * Words).
  [[nodiscard]] friend constexpr Wide operator<<(const Wide& a, int count) noexcept {
    const int jump = count / 64, bits = count % 64;
    Wide shifted;
    for (int i = Words - 1; i >= jump; --i) {
      std::uint64_t word = a.word(i - jump) << bits;
      if (bits != 0 && i > jump) word |= a.word(i - jump - 1) >> (64 - bits);
      shifted.words_[index(i)] = word;
    }
    return shifted;
  }

  /// Rounds toward minus infinity. `count` in [0, 64 * Words).
  [[nodiscard]] friend constexpr Wide operator>>(const Wide& a, int count) noexcept {
    const int jump = count / 64, bits = count % 64;
    const std::uint64_t sign = a.is_negative() ? ~std::uint64_t{0} : 0;
    Wide shifted;
    for (int i = 0; i < Words; ++i) {
      const std::uint64_t low = i + jump < Words ? a.word(i + jump) : sign;
      const std::uint64_t high = i + jump + 1 < Words ? a.word(i + jump + 1) : sign;
      shifted.words_[index(i)] = bits == 0 ? low : (low >> bits) | (high << (64 - bits));
    }
    return shifted;
  }

  [[nodiscard]] friend constexpr bool operator==(const Wide& a, const Wide& b) noexcept = default;

  [[nodiscard]] DETENT_INLINE_WHEN_SHORT friend constexpr std::strong_ordering operator<=>(
      const Wide& a, const Wide& b) noexcept {
    constexpr int top = Words - 1;
    if constexpr (Words == 2) {
      if (a.word(1) == b.word(1)) return a.word(0) <=> b.word(0);
    }
    if (a.word(top) != b.word(top)) {
      return static_cast<std::int64_t>(a.word(top)) <=> static_cast<std::int64_t>(b.word(top));
    }
    for (int i = top - 1; i >= 0; --i) {
      if (a.word(i) != b.word(i)) return a.word(i) <=> b.word(i);
    }
    return std::strong_ordering::equal;
  }

 private:
  static DETENT_INLINE_TINY constexpr std::size_t index(int i) noexcept {
    return static_cast<std::size_t>(i);
  }

  constexpr void fill_from(int first, bool negative) noexcept {
    for (int i = first; i < Words; ++i) words_[index(i)] = negative ? ~std::uint64_t{0} : 0;
  }

  std::array<std::uint64_t, std::size_t{Words}> words_{};
};

/// a * b modulo 2^(64 * Result), from 32-bit halves of a.
template <int Result, int A>
[[nodiscard]] constexpr Wide<Result> multiply_by_half(const Wide<A>& a, std::int32_t b) noexcept {
  std::array<std::uint64_t, std::size_t{Result}> words{};
  std::uint64_t sum = 0;
  const auto next_half = [&](std::uint64_t half) {
    if (!has_short_products || half != 0)
      sum += multiply_halves(static_cast<std::uint32_t>(half), b);
    const auto low = static_cast<std::uint32_t>(sum);
    sum = signed_high_half(sum);
    return std::uint64_t{low};
  };
  const std::uint64_t above = a.is_negative() ? ~std::uint64_t{0} : 0;
  for (int i = 0; i < Result; ++i) {
    const std::uint64_t word = i < A ? a.word(i) : above;
    const std::uint64_t low = next_half(word & 0xffffffff);
    words[static_cast<std::size_t>(i)] = (next_half(word >> 32) << 32) | low;
  }
  return Wide<Result>::from_words(words);
}

/// |x|, the lowest 32 bits first.
template <int Words>
[[nodiscard]] constexpr auto halves_of_magnitude(const Wide<Words>& x) noexcept {
  const Wide<Words> magnitude = x.is_negative() ? -x : x;
  std::array<std::uint32_t, std::size_t{2} * Words> halves{};
  for (int i = 0; i < 2 * Words; ++i) {
    halves[static_cast<std::size_t>(i)] =
        static_cast<std::uint32_t>(magnitude.word(i / 2) >> (32 * (i % 2)));
  }
  return halves;
}

/// a * b modulo 2^(64 * Result), from 32-bit halves of the magnitudes: shorter ones need fewer
/// products.
template <int Result, int A, int B>
[[nodiscard]] constexpr Wide<Result> multiply_by_halves(const Wide<A>& a,
                                                        const Wide<B>& b) noexcept {
  const auto at = [](auto& array, int i) -> auto& { return array[static_cast<std::size_t>(i)]; };
  const auto x = halves_of_magnitude(a);
  const auto y = halves_of_magnitude(b);
  int length = 2 * B;
  while (length > 0 && at(y, length - 1) == 0) --length;

  std::array<std::uint32_t, std::size_t{2} * Result> sum{};
  for (int i = 0; i < 2 * A && i < 2 * Result; ++i) {
    if (at(x, i) == 0) continue;
    std::uint64_t carry = 0;
    int k = i;
    for (int j = 0; j < length && k < 2 * Result; ++j, ++k) {
      carry += multiply_halves(at(x, i), at(y, j));  // at most (2^32 - 1)^2 + 2 (2^32 - 1)
      carry += at(sum, k);
      at(sum, k) = static_cast<std::uint32_t>(carry);
      carry >>= 32;
    }
    if (k < 2 * Result) at(sum, k) = static_cast<std::uint32_t>(carry);
  }
  std::array<std::uint64_t, std::size_t{Result}> words{};
  for (int i = 0; i < Result; ++i) {
    at(words, i) = (std::uint64_t{at(sum, 2 * i + 1)} << 32) | at(sum, 2 * i);
  }
  const auto product = Wide<Result>::from_words(words);
  return a.is_negative() != b.is_negative() ? -product : product;
}

#if DETENT_NATIVE_INT128
/// a * b for two words each, without branches.
template <int Result>
[[nodiscard]] constexpr Wide<Result> multiply_pairs(const Wide<2>& a, const Wide<2>& b) noexcept {
  const auto times = [&](int i, int j) { return static_cast<UInt128>(a.word(i)) * b.word(j); };
  const UInt128 bottom = times(0, 0), left = times(0, 1), right = times(1, 0);
  const UInt128 middle =
      (bottom >> 64) + static_cast<std::uint64_t>(left) + static_cast<std::uint64_t>(right);
  UInt128 high = times(1, 1) + (left >> 64) + (right >> 64) + (middle >> 64);
  high -= a.is_negative() ? b.pair(0) : 0;
  high -= b.is_negative() ? a.pair(0) : 0;
  return Wide<Result>::from_pairs((middle << 64) | static_cast<std::uint64_t>(bottom), high);
}
/// The same for two words and one.
template <int Result>
[[nodiscard]] constexpr Wide<Result> multiply_pair(const Wide<2>& a, std::int64_t b) noexcept {
  const auto pattern = static_cast<std::uint64_t>(b);
  const UInt128 bottom = static_cast<UInt128>(a.word(0)) * pattern;
  UInt128 high = static_cast<UInt128>(a.word(1)) * pattern + (bottom >> 64);
  high -= b < 0 ? a.pair(0) : 0;
  high -= a.is_negative() ? static_cast<UInt128>(pattern) << 64 : 0;
  const auto top = static_cast<std::uint64_t>(static_cast<Int128>(high) >> 127);
  const auto middle = static_cast<std::uint64_t>(high);
  return Wide<Result>::from_pairs(
      (static_cast<UInt128>(middle) << 64) | static_cast<std::uint64_t>(bottom),
      (static_cast<UInt128>(top) << 64) | static_cast<std::uint64_t>(high >> 64));
}
#endif

// Schoolbook product of the unsigned patterns u(a) and u(b). A negative a is u(a) - 2^(64 A),
// so a * b = u(a) * u(b) - [b < 0] * u(a) * 2^(64 B) - [a < 0] * b * 2^(64 A).
template <int Result, int A, int B>
constexpr Wide<Result> multiply(const Wide<A>& a, const Wide<B>& b) noexcept {
#if DETENT_SHORT_WORDS
  return multiply_by_halves<Result>(a, b);
#else
#if DETENT_NATIVE_INT128
  if constexpr (A == 2 && B == 2 && Result >= 4) return multiply_pairs<Result>(a, b);
#endif
  std::array<std::uint64_t, std::size_t{Result}> sum{};
  const auto at = [&sum](int i) -> std::uint64_t& { return sum[static_cast<std::size_t>(i)]; };
  for (int i = 0; i < A && i < Result; ++i) {
    std::uint64_t carry = 0;
    for (int j = 0; j < B && i + j < Result; ++j) {
      auto [low, high] = multiply_words(a.word(i), b.word(j));
      low += carry;
      high += low < carry ? 1u : 0u;
      at(i + j) += low;
      carry = high + (at(i + j) < low ? 1u : 0u);
    }
    if (i + B < Result) at(i + B) = carry;
  }
  const auto subtract_above = [&](int first, auto word) {
    std::uint64_t borrow = 0;
    for (int i = first; i < Result; ++i) {
      const std::uint64_t before = at(i), partial = before - borrow, subtrahend = word(i - first);
      borrow = (partial > before ? 1u : 0u) + (partial < subtrahend ? 1u : 0u);
      at(i) = partial - subtrahend;
    }
  };
  const std::uint64_t b_sign = b.is_negative() ? ~std::uint64_t{0} : 0;
  if (a.is_negative()) subtract_above(A, [&](int i) { return i < B ? b.word(i) : b_sign; });
  if (b.is_negative()) {
    subtract_above(B, [&](int i) { return i < A ? a.word(i) : std::uint64_t{0}; });
  }
  return Wide<Result>::from_words(sum);
#endif
}

}  // namespace detent
