// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "detent/number/fixed.hpp"

#if __STDC_HOSTED__
#include <iosfwd>
#include <string>
#endif

namespace detent {

namespace detail {

// A magnitude is an array of 32-bit limbs, lowest first: text must be exact for every width, and
// 32-bit steps keep the code small on 32-bit chips.

template <int Bits>
using Limbs = std::array<std::uint32_t, static_cast<std::size_t>((Bits + 31) / 32)>;

/// x = x * factor + addend; returns what did not fit.
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

/// A decimal as spelt: the significant digits d1 d2 d3 ... of 0.d1d2d3... * 10^point, d1 > 0.
struct Decimal {
  bool negative = false;
  std::string_view digits;  // from d1 on, perhaps with one '.' among them; empty for zero
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
  // Longer than any text, so a larger exponent decides the result alone; ten times it still fits.
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
/// The rounding is decided by multiples of 2^-(frac+1), which have at most frac + 1 decimals. So
/// that many digits of the fraction are kept; of later digits only whether any is not 0.
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

/// The number a decimal text denotes, or nothing when it is malformed or out of range.
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

/// The most characters that `to_chars` writes for a number of type `T`.
template <class T>
inline constexpr std::size_t max_text_length = 0;
template <int Bits, int Frac>
inline constexpr std::size_t max_text_length<Fixed<Bits, Frac>> =
    1 + static_cast<std::size_t>((Bits > Frac ? Bits - Frac : 0) * 30103 / 100000 + 1) +
    static_cast<std::size_t>(Frac > 0 ? 1 + Frac : 0);

/// Writes `x` as the shortest decimal that is exactly `x`: "1", "0.5", "-0.0000152587890625".
/// Returns the end of the text; if it does not fit, writes nothing and returns nullptr.
///
/// result: no exponent, no trailing zeros; at most `max_text_length<Fixed<Bits, Frac>>` characters;
///         `parse` returns every `x` up to max() unchanged
template <int Bits, int Frac>
requires(Frac >= 0) constexpr char* to_chars(char* first, char* last,
                                             const Fixed<Bits, Frac>& x) noexcept {
  // Shifted so that the binary point lies between two limbs.
  constexpr int fraction_limbs = (Frac + 31) / 32;
  constexpr int whole_bits = Bits > Frac ? Bits - Frac : 0;
  using Limbs = detail::Limbs<32 * fraction_limbs + whole_bits + 1>;
  Limbs limbs = detail::limbs_of<std::tuple_size_v<Limbs>>(x.raw());
  detail::multiply_add(limbs, std::uint32_t{1} << (32 * fraction_limbs - Frac), 0);
  const auto fraction = std::span(limbs).template first<fraction_limbs>();
  const auto whole = std::span(limbs).template subspan<fraction_limbs>();

  constexpr std::size_t length = max_text_length<Fixed<Bits, Frac>>;
  constexpr std::size_t point = length - (Frac > 0 ? 1 + Frac : 0);
  std::array<char, length> text{};
  std::size_t begin = point;
  do {
    text[--begin] = static_cast<char>('0' + detail::divide_by_ten(whole));
  } while (!detail::is_zero(whole));
  if (x.raw() < typename Fixed<Bits, Frac>::raw_type(0)) text[--begin] = '-';
  std::size_t end = point;
  if (!detail::is_zero(fraction)) text[end++] = '.';
  while (!detail::is_zero(fraction)) {
    text[end++] = static_cast<char>('0' + detail::multiply_add(fraction, 10, 0));
  }

  if (last - first < static_cast<std::ptrdiff_t>(end - begin)) return nullptr;
  for (std::size_t i = begin; i < end; ++i) *first++ = text[i];
  return first;
}

#if __STDC_HOSTED__
/// The shortest decimal that is exactly `x`.
template <int Bits, int Frac>
requires(Frac >= 0) [[nodiscard]] std::string to_string(const Fixed<Bits, Frac>& x) {
  std::array<char, max_text_length<Fixed<Bits, Frac>>> text{};
  return std::string(text.data(), to_chars(text.data(), text.data() + text.size(), x));
}

/// Writes `x` as `to_string` does, with the stream's width and fill.
template <class Traits, int Bits, int Frac>
requires(Frac >= 0) std::basic_ostream<char, Traits>
&operator<<(std::basic_ostream<char, Traits>& out, const Fixed<Bits, Frac>& x) {
  // cppcheck-suppress stlcstrStream  // the stream's traits may differ
  return out << to_string(x).c_str();
}
#endif

namespace detail {

/// The value of a literal's digits, and whether it or its negative is in range.
template <class T>
struct LiteralValue {
  T value;
  bool fits;
  bool fits_negated;
};

template <class T>
consteval LiteralValue<T> parse_literal(std::string_view spelling) {
  // Digit separators are dropped. 010 is refused: it would be 8 in C++ and ten to a reader.
  std::array<char, 512> text{'-'};
  std::size_t length = 1;
  bool is_integer = true;
  for (const char c : spelling) {
    if (c == '\'') continue;
    is_integer = is_integer && is_digit(c);
    if (length < text.size()) text[length] = c;
    ++length;
  }
  const bool is_octal = is_integer && length > 2 && text[1] == '0';
  if (is_octal || length >= text.size()) return {T(), false, false};
  const std::optional<T> value = T::parse({text.data() + 1, length - 1});
  return {value.value_or(T()), value.has_value(), T::parse({text.data(), length}).has_value()};
}

/// The type of a literal of which only the negative is in range, such as 32768_q16_16. The minus
/// sign is its only operation.
template <class T>
struct only_the_negative_of_this_literal_is_in_range {
  constexpr only_the_negative_of_this_literal_is_in_range() noexcept = default;
  only_the_negative_of_this_literal_is_in_range(
      const only_the_negative_of_this_literal_is_in_range&) = delete;
  void operator=(const only_the_negative_of_this_literal_is_in_range&) = delete;
};
template <class T>
inline constexpr only_the_negative_of_this_literal_is_in_range<T> needs_a_minus_sign;
template <class T>
[[nodiscard]] consteval T operator-(const only_the_negative_of_this_literal_is_in_range<T>&) {
  return T::lowest();
}

/// Returns a `const` value, unlike other functions, so that the minus sign recognizes a literal.
template <class T, char... Spelling>
[[nodiscard]] constexpr decltype(auto) literal() noexcept {
  constexpr std::array<char, sizeof...(Spelling)> spelling{Spelling...};
  constexpr LiteralValue<T> number = parse_literal<T>({spelling.data(), spelling.size()});
  static_assert(number.fits || number.fits_negated,
                "detent: this literal is not a decimal in the range of its type");
  if constexpr (number.fits || !number.fits_negated) {
    using Constant = const T;
    return Constant(number.value);
  } else {
    return static_cast<const only_the_negative_of_this_literal_is_in_range<T>&>(
        needs_a_minus_sign<T>);
  }
}

}  // namespace detail

/// `1.25_q16_16`: the nearest number of that type, at compile time. A literal that is malformed or
/// out of range does not compile. A minus sign before a literal keeps its type: -32768_q16_16 is a
/// q16_16.
namespace literals {

template <char... Spelling>
[[nodiscard]] constexpr decltype(auto) operator""_q16_16() noexcept {
  return detail::literal<q16_16, Spelling...>();
}
template <char... Spelling>
[[nodiscard]] constexpr decltype(auto) operator""_q14_16() noexcept {
  return detail::literal<q14_16, Spelling...>();
}
template <char... Spelling>
[[nodiscard]] constexpr decltype(auto) operator""_q24_8() noexcept {
  return detail::literal<q24_8, Spelling...>();
}
template <char... Spelling>
[[nodiscard]] constexpr decltype(auto) operator""_q8_8() noexcept {
  return detail::literal<q8_8, Spelling...>();
}

}  // namespace literals

}  // namespace detent
