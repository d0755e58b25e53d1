// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>

#include "detent/number/decimal.hpp"

#if __STDC_HOSTED__
#include <iosfwd>
#include <string>
#endif

namespace detent {

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

}  // namespace detent
