// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "detent/number/fixed.hpp"

namespace detent {

namespace detail {

// A magnitude is an array of 32-bit limbs, lowest first: text must be exact for every width, and
// 32-bit steps keep the code small on 32-bit chips.

template <int Bits>
using Limbs = std::array<std::uint32_t, static_cast<std::size_t>((Bits + 31) / 32)>;

/// x = x * factor + addend; returns the carry.
constexpr std::uint32_t multiply_add(std::span<std::uint32_t> x, std::uint32_t factor,
                                     std::uint32_t addend) noexcept {
  std::uint64_t carry = addend;
  for (std::uint32_t& limb : x) {
    carry += std::uint64_t{limb} * factor;
    limb = static_cast<std::uint32_t>(carry);
    carry >>= 32;
  }
  return static_cast<std::uint32_t>(carry);
}

/// x = floor(x / 10); returns the remainder.
constexpr std::uint32_t divide_by_ten(std::span<std::uint32_t> x) noexcept {
  std::uint32_t remainder = 0;
  for (std::size_t i = x.size(); i-- > 0;) {
    const std::uint64_t part = (std::uint64_t{remainder} << 32) | x[i];
    x[i] = static_cast<std::uint32_t>(part / 10);
    remainder = static_cast<std::uint32_t>(part % 10);
  }
  return remainder;
}

constexpr bool is_zero(std::span<const std::uint32_t> x) noexcept {
  for (const std::uint32_t limb : x) {
    if (limb != 0) return false;
  }
  return true;
}

/// |raw|; limbs beyond its width are 0.
template <std::size_t Size, class Raw>
constexpr std::array<std::uint32_t, Size> limbs_of(const Raw& raw) noexcept {
  const bool negative = raw < Raw(0);
  std::array<std::uint32_t, Size> limbs{};
  std::uint64_t carry = negative ? 1 : 0;  // |raw| = ~raw + 1 when raw is negative
  for (std::size_t i = 0; i < Size && 4 * i < sizeof(Raw); ++i) {
    const auto word = integer_cast<std::uint64_t>(shift_right_floor(raw, static_cast<int>(32 * i)));
    carry += static_cast<std::uint32_t>(negative ? ~word : word);
    limbs[i] = static_cast<std::uint32_t>(carry);
    carry >>= 32;
  }
  return limbs;
}

/// The raw integer of a magnitude that is known to fit.
template <class Raw, std::size_t Size>
constexpr Raw raw_of(const std::array<std::uint32_t, Size>& limbs, bool negative) noexcept {
  constexpr int words = words_of<Raw>;
  std::array<std::uint64_t, std::size_t{words < 2 ? 2 : words}> pattern{};
  for (std::size_t i = 0; i < Size; ++i)
    pattern[i / 2] |= std::uint64_t{limbs[i]} << (32 * (i % 2));
  const auto magnitude = Wide<(words < 2 ? 2 : words)>::from_words(pattern);
  return integer_cast<Raw>(negative ? -magnitude : magnitude);
}

constexpr bool is_digit(char c) noexcept { return c >= '0' && c <= '9'; }

/// A parsed decimal: the significant digits d1 d2 d3 ... of 0.d1d2d3... * 10^point, d1 > 0.
struct Decimal {
  bool negative = false;
  std::string_view digits;  // from d1 on, possibly with one '.'; empty for zero
  std::int64_t point = 0;

  /// Takes the next digit; zeros follow the last one.
  constexpr std::uint32_t next() noexcept {
    if (!digits.empty() && digits.front() == '.') digits.remove_prefix(1);
    if (digits.empty()) return 0;
    const auto digit = static_cast<std::uint32_t>(digits.front() - '0');
    digits.remove_prefix(1);
    return digit;
  }
};

/// [+-] digits [. digits] [(e|E) [+-] digits], at least one digit before the exponent; nothing
/// else.
constexpr std::optional<Decimal> scan_decimal(std::string_view text) noexcept {
  // Longer than any text, so any larger exponent decides the result; ten times the limit still
  // fits.
  constexpr std::int64_t exponent_limit = 100'000'000'000'000'000;
  std::size_t at = 0;
  const auto look = [&] { return at < text.size() ? text[at] : '\0'; };
  const auto skip_sign = [&] {
    const char sign = look();
    if (sign == '+' || sign == '-') ++at;
    return sign == '-';
  };

  Decimal decimal;
  decimal.negative = skip_sign();
  const std::size_t begin = at;
  while (is_digit(look())) ++at;
  const std::size_t whole_end = at;
  if (look() == '.') {
    ++at;
    while (is_digit(look())) ++at;
  }
  const std::size_t end = at;
  const std::size_t digit_count = end - begin - (end > whole_end ? 1 : 0);
  if (digit_count == 0) return std::nullopt;

  std::int64_t exponent = 0;
  if (look() == 'e' || look() == 'E') {
    ++at;
    const bool negative = skip_sign();
    if (!is_digit(look())) return std::nullopt;
    for (; is_digit(look()); ++at) {
      if (exponent < exponent_limit) exponent = exponent * 10 + (look() - '0');
    }
    if (exponent > exponent_limit) exponent = exponent_limit;
    if (negative) exponent = -exponent;
  }
  if (at != text.size()) return std::nullopt;

  std::size_t first = begin;
  while (first < end && (text[first] == '0' || text[first] == '.')) ++first;
  if (first == end) return decimal;
  decimal.digits = {text.data() + first, end - first};  // substr would pull in exception code
  decimal.point = exponent + static_cast<std::int64_t>(whole_end) -
                  static_cast<std::int64_t>(first) + (first > whole_end ? 1 : 0);
  return decimal;
}

/// |decimal| * 2^frac rounded to nearest, ties to even; nothing when it does not fit into `result`.
///
/// Multiples of 2^-(frac+1) decide the rounding. They have at most frac + 1 decimals, so it keeps
/// that many digits of the fraction, and for later digits only whether any is nonzero.
template <int Frac>
constexpr bool round_decimal(Decimal decimal, std::span<std::uint32_t> result) noexcept {
  for (std::uint32_t& limb : result) limb = 0;
  if (decimal.digits.empty()) return true;
  for (std::int64_t i = 0; i < decimal.point; ++i) {  // d1 > 0, so this ends soon
    if (multiply_add(result, 10, decimal.next()) != 0) return false;
  }

  std::array<std::uint32_t, static_cast<std::size_t>(Frac / 9 + 1)> billionths{};  // highest first
  std::int64_t zeros = decimal.point < 0 ? -decimal.point : 0;
  for (std::uint32_t& limb : billionths) {
    for (int i = 0; i < 9; ++i) limb = limb * 10 + (zeros-- > 0 ? 0 : decimal.next());
  }
  bool inexact = false;
  while (!inexact && !decimal.digits.empty()) inexact = decimal.next() != 0;

  const auto take_bits = [&billionths](int count) {
    std::uint64_t carry = 0;
    for (std::size_t i = billionths.size(); i-- > 0;) {
      carry += std::uint64_t{billionths[i]} << count;
      billionths[i] = static_cast<std::uint32_t>(carry % 1'000'000'000);
      carry /= 1'000'000'000;
    }
    return static_cast<std::uint32_t>(carry);
  };
  for (int left = Frac; left > 0; left -= 16) {
    const int count = left < 16 ? left : 16;
    if (multiply_add(result, std::uint32_t{1} << count, take_bits(count)) != 0) return false;
  }
  const bool half = take_bits(1) != 0;
  inexact = inexact || !is_zero(billionths);
  const bool round_up = half && (inexact || (result[0] & 1) != 0);
  return multiply_add(result, 1, round_up ? 1 : 0) == 0;
}

}  // namespace detail

/// The number written as decimal text, or nothing if it is malformed or out of range.
///
/// domain: [+-] digits [. digits] [(e|E) [+-] digits], of any length: "-1.25", ".5", "5.", "1e-3";
///         no spaces, no other characters
/// exact:  the decimal's exact value rounded to nearest, ties to even; the range is checked after
///         rounding                                                       (tests/number/text)
template <int Bits, int Frac>
constexpr std::optional<Fixed<Bits, Frac>> Fixed<Bits, Frac>::parse(
    std::string_view text) noexcept {
  static_assert(Frac >= 0, "detent: text needs a grid that contains the integers");
  const std::optional<detail::Decimal> decimal = detail::scan_decimal(text);
  if (!decimal) return std::nullopt;
  detail::Limbs<Bits + 1> magnitude{};
  if (!detail::round_decimal<Frac>(*decimal, magnitude)) return std::nullopt;
  const auto limit =
      detail::limbs_of<magnitude.size()>((decimal->negative ? lowest() : (max)()).raw());
  for (std::size_t i = magnitude.size(); i-- > 0;) {
    if (magnitude[i] > limit[i]) return std::nullopt;
    if (magnitude[i] < limit[i]) break;
  }
  return from_raw(detail::raw_of<raw_type>(magnitude, decimal->negative));
}

}  // namespace detent
