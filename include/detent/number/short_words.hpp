// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "detent/number/require_cxx20.hpp"

// DETENT_SHORT_WORDS is 1 with 32-bit registers: wide integers are then computed in half words.
// Define it to choose; it changes speed, never a result.
#ifndef DETENT_SHORT_WORDS
#if UINTPTR_MAX <= 0xffffffff && !defined(__wasm__) && !defined(__x86_64__)
#define DETENT_SHORT_WORDS 1
#else
#define DETENT_SHORT_WORDS 0
#endif
#endif

// On such machines compilers consider a sum of wide integers too long to inline, although passing
// its operands through memory takes longer than the sum.
#if DETENT_SHORT_WORDS && defined(__GNUC__) && !defined(__OPTIMIZE_SIZE__)
#define DETENT_INLINE_WHEN_SHORT __attribute__((always_inline))
#else
#define DETENT_INLINE_WHEN_SHORT
#endif

// Without optimization compilers inline nothing, and a game spends half its time calling tiny
// functions (./dev size compile). DETENT_INLINE_UNOPTIMIZED is 1 to inline these all the same. Define
// it as 0 where compile time matters more: an eighth less of it, for code a third slower.
#ifndef DETENT_INLINE_UNOPTIMIZED
#define DETENT_INLINE_UNOPTIMIZED 1
#endif
#if DETENT_INLINE_UNOPTIMIZED && defined(__GNUC__) && !defined(__OPTIMIZE__)
#define DETENT_INLINE_TINY __attribute__((always_inline))
#else
#define DETENT_INLINE_TINY DETENT_INLINE_WHEN_SHORT
#endif

// For the exact answer behind a filter: if g++ inlined it, it would save registers for it before every
// filtered one.
#if defined(__GNUC__)
#define DETENT_OUTLINE __attribute__((noinline))
#else
#define DETENT_OUTLINE
#endif

// For a filter that is a query's usual answer: in a long source, g++ would pass its numbers through
// memory and wait for them.
#if defined(__GNUC__) && defined(__OPTIMIZE__) && !defined(__OPTIMIZE_SIZE__)
#define DETENT_INLINE_FILTER __attribute__((always_inline))
#else
#define DETENT_INLINE_FILTER
#endif

namespace detent {

/// Whether the processor keeps only 32 bits of a product and has no division: Cortex-M0, M0+, M1.
#if defined(__ARM_ARCH_6M__)
inline constexpr bool has_short_products = true;
#else
inline constexpr bool has_short_products = false;
#endif

/// The two halves of a 128-bit product.
struct WordProduct {
  std::uint64_t low;
  std::uint64_t high;
};

/// The exact product of two 32-bit numbers, each signed or not, as a pattern of 64 bits, from
/// pieces of 16 bits.
template <class A, class B>
[[nodiscard]] DETENT_INLINE_WHEN_SHORT constexpr std::uint64_t multiply_halves_portable(
    A a, B b) noexcept {
  static_assert(sizeof(A) == 4 && sizeof(B) == 4);
  using U = std::uint32_t;
  const U a0 = static_cast<U>(a) & 0xffff, a1 = static_cast<U>(a >> 16);
  const U b0 = static_cast<U>(b) & 0xffff, b1 = static_cast<U>(b >> 16);
  const U low = a0 * b0;
  // At most (2^16 - 1) * 2^16 for an unsigned a, in [-2^31, 2^31) for a signed one: both fit.
  const A middle = static_cast<A>(a1 * b0 + (low >> 16));
  const B cross = static_cast<B>(a0 * b1 + (static_cast<U>(middle) & 0xffff));
  const U high = a1 * b1 + static_cast<U>(middle >> 16) + static_cast<U>(cross >> 16);
  return (std::uint64_t{high} << 32) | (static_cast<U>(cross) << 16) | (low & 0xffff);
}

/// The exact product of two 32-bit numbers, each signed or not, as a pattern of 64 bits.
template <class A, class B>
[[nodiscard]] DETENT_INLINE_WHEN_SHORT constexpr std::uint64_t multiply_halves(A a, B b) noexcept {
  if constexpr (has_short_products) {
    return multiply_halves_portable(a, b);
  } else {
    return static_cast<std::uint64_t>(std::int64_t{a}) *
           static_cast<std::uint64_t>(std::int64_t{b});
  }
}

/// x / 2^32 rounded down, for the signed number with the pattern x.
[[nodiscard]] DETENT_INLINE_WHEN_SHORT constexpr std::uint64_t signed_high_half(
    std::uint64_t x) noexcept {
  return static_cast<std::uint64_t>(static_cast<std::int64_t>(x) >> 32);
}

/// The exact product of two signed integers of at most 64 bits, from 32-bit halves.
///
/// source: Warren, Hacker's Delight, 8-2
template <class A, class B>
[[nodiscard]] DETENT_INLINE_WHEN_SHORT constexpr WordProduct multiply_signed_halves(A a,
                                                                                    B b) noexcept {
  if constexpr (sizeof(A) <= 4 && sizeof(B) <= 4) {
    const std::uint64_t product = multiply_halves(std::int32_t{a}, std::int32_t{b});
    // cppcheck-suppress shiftTooManyBitsSigned  // defined in C++20: the sign
    return {product, static_cast<std::uint64_t>(static_cast<std::int64_t>(product) >> 63)};
  } else if constexpr (sizeof(A) <= 4) {
    return multiply_signed_halves(b, a);
  } else if constexpr (sizeof(B) <= 4) {
    const auto half = std::int32_t{b};
    const std::uint64_t low = multiply_halves(static_cast<std::uint32_t>(a), half);
    const std::uint64_t high =
        multiply_halves(static_cast<std::int32_t>(a >> 32), half) + signed_high_half(low);
    return {(high << 32) | static_cast<std::uint32_t>(low), signed_high_half(high)};
  } else {
    const auto a0 = static_cast<std::uint32_t>(a), b0 = static_cast<std::uint32_t>(b);
    const auto a1 = static_cast<std::int32_t>(a >> 32), b1 = static_cast<std::int32_t>(b >> 32);
    if constexpr (has_short_products) {  // a single product saves more than this test costs
      const auto short_a = static_cast<std::int32_t>(a0), short_b = static_cast<std::int32_t>(b0);
      // cppcheck-suppress shiftTooManyBitsSigned  // defined in C++20: the sign
      if (a1 == short_a >> 31 && b1 == short_b >> 31) {
        return multiply_signed_halves(short_a, short_b);
      }
    }
    const std::uint64_t low = multiply_halves(a0, b0);
    const std::uint64_t middle = multiply_halves(a1, b0) + (low >> 32);
    const std::uint64_t cross = multiply_halves(a0, b1) + static_cast<std::uint32_t>(middle);
    return {(cross << 32) | static_cast<std::uint32_t>(low),
            multiply_halves(a1, b1) + signed_high_half(middle) + signed_high_half(cross)};
  }
}

/// The product of two signed integers of at most 64 bits modulo 2^64, from 32-bit halves.
template <class A, class B>
[[nodiscard]] DETENT_INLINE_WHEN_SHORT constexpr std::uint64_t multiply_low_halves(A a,
                                                                                   B b) noexcept {
  const auto low = [](auto x) { return static_cast<std::uint32_t>(x); };
  if constexpr (sizeof(A) <= 4 && sizeof(B) <= 4) {
    return multiply_halves(std::int32_t{a}, std::int32_t{b});
  } else if constexpr (sizeof(A) <= 4) {
    return multiply_low_halves(b, a);
  } else if constexpr (sizeof(B) <= 4) {
    return multiply_halves(low(a), std::int32_t{b}) + (std::uint64_t{low(a >> 32) * low(b)} << 32);
  } else {
    return multiply_halves(low(a), low(b)) +
           (std::uint64_t{low(a >> 32) * low(b) + low(a) * low(b >> 32)} << 32);
  }
}

template <class Word>
struct WordDivision {
  Word quotient;
  Word remainder;
};
using HalfDivision = WordDivision<std::uint32_t>;

/// floor(n / d) and the remainder of the double word n = (high, low), for high < d and a d whose
/// first bit is set, from divisions of words.
///
/// source: Warren, Hacker's Delight, 2nd ed., 9-4, divlu
template <class Word>
[[nodiscard]] constexpr WordDivision<Word> divide_double_word(Word high, Word low,
                                                              Word d) noexcept {
  constexpr int half = 4 * sizeof(Word);
  constexpr Word mask = (Word{1} << half) - 1;
  const Word d1 = d >> half, d0 = d & mask;
  Word rest = high;
  const auto next_digit = [&](Word next) {
    Word digit = rest / d1, left = rest % d1;
    while (digit >> half != 0 || digit * d0 > ((left << half) | next)) {
      --digit;
      left += d1;
      if (left >> half != 0) break;
    }
    rest = ((rest << half) | next) - digit * d;
    return digit;
  };
  const Word first = next_digit(low >> half);
  const Word second = next_digit(low & mask);
  return {(first << half) | second, rest};
}

/// floor(n / d) and the remainder, for d >= 2^31 and a quotient below 2^32, from 32-bit divisions.
[[nodiscard]] constexpr HalfDivision divide_halves_portable(std::uint64_t n,
                                                            std::uint32_t d) noexcept {
  return divide_double_word(static_cast<std::uint32_t>(n >> 32), static_cast<std::uint32_t>(n), d);
}

/// floor(n / d) and the remainder, for d >= 2^31 and a quotient below 2^32.
[[nodiscard]] constexpr HalfDivision divide_halves(std::uint64_t n, std::uint32_t d) noexcept {
  if constexpr (has_short_products) {
    return divide_halves_portable(n, d);
  } else {
    return {static_cast<std::uint32_t>(n / d), static_cast<std::uint32_t>(n % d)};
  }
}

}  // namespace detent
