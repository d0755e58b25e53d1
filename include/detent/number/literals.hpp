// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "detent/number/decimal.hpp"

namespace detent {

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

/// The type of a literal whose negative alone is in range, such as 32768_q16_16. It has only a
/// minus sign.
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
[[nodiscard]] DETENT_CONSTEVAL T
operator-(const only_the_negative_of_this_literal_is_in_range<T>&) {
  return T::lowest();
}

/// Returns a `const` value, so that the minus sign recognizes a literal.
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
