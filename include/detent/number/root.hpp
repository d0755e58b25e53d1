// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "detent/number/wide.hpp"

namespace detent {

namespace detail {

/// Chords of the square root. Entry i - 64 covers x in [i/256, (i+1)/256): the value at the left
/// end (upper 20 bits, Q20) and the rise to the right end (lower 12 bits, Q20).
inline constexpr auto root_chords = [] {
  // floor(sqrt(i * 2^32)) = floor(2^20 * sqrt(i / 256)), digit by digit: compile time only.
  const auto left_end = [](std::uint32_t i) {
    std::uint32_t root = 0;
    for (std::uint32_t digit = std::uint32_t{1} << 20; digit != 0; digit >>= 1) {
      const std::uint64_t next = root | digit;
      if (next * next <= std::uint64_t{i} << 32) root |= digit;
    }
    return root;
  };
  std::array<std::uint32_t, 192> chords{};
  for (std::uint32_t i = 64; i < 256; ++i) {
    chords[i - 64] = (left_end(i) << 12) | (left_end(i + 1) - left_end(i));
  }
  return chords;
}();

/// sqrt(a) / 2^12 for a >= 2^62, from a chord: at least 2^19, and below 2^20.
///
/// A chord lies below the root by at most 2^-17 of it, and quantizing adds 2^-19.
constexpr std::uint32_t root_guess(std::uint64_t a) noexcept {
  const std::uint32_t chord = root_chords[static_cast<std::size_t>(a >> 56) - 64];
  const std::uint64_t along = (a >> 40) & 0xffff;
  return (chord >> 12) + static_cast<std::uint32_t>(((chord & 0xfff) * along) >> 16);  // Q20
}

/// A line: y = offset - fall t, modulo 2^32.
struct FallingLine {
  std::uint32_t offset, fall;
};

/// Chords of 2^30 / sqrt(x), lowered by half their greatest distance from the curve. Entry i - 63
/// covers x in [i/256, (i+1)/256), with t = floor(2^20 x).
inline constexpr auto reciprocal_root_chords = [] {
  // floor(2^26 * sqrt(512 / i)), digit by digit: compile time only. Half entries for the middle.
  const auto value = [](std::uint64_t i) {
    std::uint64_t root = 0;
    for (std::uint64_t digit = std::uint64_t{1} << 28; digit != 0; digit >>= 1) {
      const std::uint64_t next = root | digit;
      if (next * next <= (std::uint64_t{512} << 52) / i) root |= digit;
    }
    return root;  // Q26
  };
  std::array<FallingLine, 193> chords{};
  for (std::uint32_t i = 63; i < 256; ++i) {
    const std::uint64_t left = value(std::uint64_t{2} * i), right = value(2 * i + 2);
    const std::uint64_t lowered = ((left + right) / 2 - value(2 * i + 1)) / 2;
    const std::uint64_t fall = (left - right + 128) >> 8;
    const std::uint64_t first = ((left - lowered) << 4) - fall / 2;  // t drops half on average
    chords[i - 63] = {static_cast<std::uint32_t>(first + fall * (i << 12)),
                      static_cast<std::uint32_t>(fall)};
  }
  return chords;
}();

/// Whether t = floor(2^20 x) has an entry.
constexpr bool has_reciprocal_root_chord(std::uint64_t t) noexcept {
  return t - (63 << 12) < (193 << 12);
}

/// 2^30 / sqrt(x) for t = floor(2^20 x), with a relative error below 2^-16.
///
/// The curve bends by 3/32 (1/256)^2 / x^2 of the value between the ends, half of which is below
/// 2^-20.4 / x^2. Rounding the fall adds at most 2^-19 sqrt(x), and dropping bits of x 2^-22 / x.
constexpr std::uint32_t reciprocal_root_chord(std::uint64_t t) noexcept {
  const FallingLine& chord = reciprocal_root_chords[static_cast<std::size_t>(t >> 12) - 63];
  return chord.offset - chord.fall * static_cast<std::uint32_t>(t);
}

/// Whether a product of words is one instruction, so that the table is worth its size.
#if UINTPTR_MAX > 0xffffffff
inline constexpr bool has_long_registers = true;
#else
inline constexpr bool has_long_registers = false;
#endif

/// floor(sqrt(a)) or one more, up to 2^32, for a >= 2^62: a chord of the root and one Newton
/// (Heron) step.
///
/// One Heron step from relative error e gives r * (1 + e^2 / (2 (1 + e))): never below r = sqrt(a),
/// and above it by less than 2^32 * 2^-33 / 2 = 1/4. Nested floors equal one floor, so the step is
/// floor(r) or floor(r) + 1.
constexpr std::uint64_t root_by_division(std::uint64_t a) noexcept {
  const std::uint32_t guess = root_guess(a);
  const std::uint64_t quotient = divide_halves((a >> 13) << 12, guess << 12).quotient;
  return (std::uint64_t{guess} << 11) + quotient;
}

/// The same, without a division: g + (a - g^2) y / 2 + 3/4 for g = a y and a chord y of 1 / r, where
/// r = sqrt(a).
///
/// For y = (1 + e) / r that is r (1 - 3 e^2 / 2 - e^3 / 2) + 3/4; what g drops, less than 3,
/// changes it by less than 2^-14. For x = a / 2^64, r = 2^32 sqrt(x) and
/// |e| < 2^-20.4 / x^2 + 2^-18 sqrt(x) + 2^-22 / x, so 3 e^2 r / 2 is below 0.7, which x = 1/4 nearly
/// reaches. So the result is the floor of a number between r and r + 1.
constexpr std::uint64_t root_by_table(std::uint64_t a) noexcept {
  const std::uint64_t reciprocal = (reciprocal_root_chord(a >> 44) + (1 << 11)) >> 12;
  const std::uint64_t guess = ((a >> 32) * reciprocal) >> 18;
  const auto rest = static_cast<std::int64_t>(a - guess * guess) >> 6;
  const std::int64_t twice = rest * static_cast<std::int64_t>(reciprocal);
  constexpr std::int64_t three_quarters = std::int64_t{3} << 43;
  return guess + static_cast<std::uint64_t>((twice + three_quarters) >> 45);
}

/// floor(sqrt(a)) or one more, up to 2^32, for a >= 2^62; exact for a square.
constexpr std::uint64_t newton_root(std::uint64_t a) noexcept {
  return has_long_registers ? root_by_table(a) : root_by_division(a);
}

/// The same, but at most 2^32 - 1.
constexpr std::uint64_t root_or_next(std::uint64_t a) noexcept {
  const std::uint64_t root = newton_root(a);
  return root - (root >> 32);  // 2^32 itself is one too many
}

/// 2^(62 + Scale) / sqrt(a 2^Dropped), or the opposite, from y, which is 2^62 / sqrt(a 2^Dropped) within
/// 2^-16, or the opposite; with a relative error below 2^-44. |y| is below 2^32.
///
/// For d = 1 - a y^2 / 2^(124 - Dropped), at most 2^-15, the root is y (1 - d)^(-1/2). That is y (1 +
/// d (4 + 3 d) / 8) and more terms, of which the next is below 2^-46. With d in steps of 2^-46 and
/// 4 + 3 d in steps of 2^-28, floors lose less than three steps of d.
template <int Scale, int Dropped = 0>
constexpr std::int64_t refined_reciprocal_root(std::uint64_t a, std::int64_t y) noexcept {
  const auto word = static_cast<std::uint64_t>(y);
  const std::uint64_t high = multiply_words(a, word * word).high;
  const auto one = std::int64_t{1} << 46;
  const std::int64_t d = one - static_cast<std::int64_t>(high >> (14 - Dropped));
  const std::int64_t series = (d * (((3 * d) >> 18) + (std::int64_t{1} << 30))) >> 31;
  return y * (std::int64_t{1} << Scale) + ((y * series) >> (46 - Scale));
}

/// 2^94 / sqrt(a) for a >= 2^62, with a relative error below 2^-44.
constexpr std::uint64_t reciprocal_root(std::uint64_t a) noexcept {
  const std::uint64_t y = has_long_registers ? std::uint64_t{reciprocal_root_chord(a >> 44)}
                                             : (std::uint64_t{1} << 50) / root_guess(a);
  const auto root = refined_reciprocal_root<31>(a, static_cast<std::int64_t>(y));
  return static_cast<std::uint64_t>(root) << 1;
}

/// `root`, or one less if its square exceeds n.
constexpr std::uint64_t at_most_root(std::uint64_t root, std::uint64_t n) noexcept {
  return root - (root * root > n ? 1u : 0u);
}

/// floor(sqrt(n)): floor(sqrt(n * 4^k)) / 2^k, rounded down. `IsBelow31Bits` skips the clamp to
/// 2^32 - 1, which such roots never need.
template <bool IsBelow31Bits>
[[nodiscard]] constexpr std::uint32_t root_floor(std::uint64_t n) noexcept {
  // 0 has no leading bit. If n | 1 is a square greater than n, its root is exact, and one more than
  // that of n.
  const std::uint64_t positive = n | 1;
  const int shift = std::countl_zero(positive) & ~1;
  const std::uint64_t even = positive << shift;
  const std::uint64_t next = IsBelow31Bits ? newton_root(even) : root_or_next(even);
  return static_cast<std::uint32_t>(at_most_root(next >> (shift / 2), n));
}

}  // namespace detail

/// floor(sqrt(n)), exactly.
[[nodiscard]] constexpr std::uint32_t square_root_floor(std::uint64_t n) noexcept {
  return detail::root_floor<false>(n);
}

/// floor(sqrt(n)) for n < 2^62, exactly.
[[nodiscard]] constexpr std::uint32_t short_root_floor(std::uint64_t n) noexcept {
  return detail::root_floor<true>(n);
}

/// floor(sqrt(high * 2^64 + low)), exactly.
///
/// source: Zimmermann, Karatsuba Square Root, INRIA RR-3805 (1999), one step: the remainder of the
///         leading root divided by that root gives the trailing half, at most 1 too large
[[nodiscard]] constexpr std::uint64_t square_root_floor(std::uint64_t high,
                                                        std::uint64_t low) noexcept {
  if (high == 0) return square_root_floor(low);
  const int shift = std::countl_zero(high) & ~1;
  if (shift != 0) {
    high = (high << shift) | (low >> (64 - shift));
    low <<= shift;
  }
  // At least 2^31.
  const std::uint64_t leading = detail::at_most_root(detail::root_or_next(high), high);
  const std::uint64_t rest = high - leading * leading;  // at most 2^33 - 2
  const std::uint64_t trailing =
      std::min<std::uint64_t>(((rest << 31) | (low >> 33)) / leading, 0xffffffff);
  std::uint64_t root = (leading << 32) | trailing;
  const auto [square_low, square_high] = multiply_words(root, root);
  root -= square_high > high || (square_high == high && square_low > low) ? 1u : 0u;
  return root >> (shift / 2);
}

}  // namespace detent
