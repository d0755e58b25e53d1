// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "detent/number/rounding.hpp"

namespace detent {

/// Whether components are those of a unit vector: none beyond 1, and the length is 1 within two
/// steps of their grid (2^-29 for Q2.30, 2^-13 for Q2.14).
template <int B, int F, std::size_t N>
[[nodiscard]] constexpr bool is_unit(const std::array<Fixed<B, F>, N>& v) noexcept {
  using Length = Fixed<F + 1, F>;
  constexpr auto one = Length(1);
  constexpr auto step = Length::from_raw(1);
  constexpr auto shortest = one - step - step, longest = one + step + step;
  Fixed<2 * F + 4, 2 * F> squared;
  for (const auto& c : v) {
    if (c > 1 || c < -1) return false;
    squared = narrow<2 * F + 4>(squared + c * c);  // at most N <= 4
  }
  return squared >= shortest * shortest && squared <= longest * longest;
}

template <std::floating_point T, std::size_t N>
[[nodiscard]] constexpr bool is_unit(const std::array<T, N>& v) noexcept {
  T squared = 0;
  for (const T c : v) squared += c * c;
  constexpr T tolerance = 16 * std::numeric_limits<T>::epsilon();
  return squared >= 1 - tolerance && squared <= 1 + tolerance;
}

/// The unit vector along `v`, or nothing for the zero vector.
///
/// exact:  each component is the exact one rounded to nearest    (tests/math/direction.test.cpp)
///
/// With every |v_i| scaled by the same power of two to t_i, the longest 62 bits long, and
/// n = floor(|t|): scaling down drops less than 1 from each t_i and less than 2 from |t|, so
/// x = 2^F |v_i| / |v| and 2^F t_i / n differ by less than 2^F * 4 / 2^61. Only when the fraction
/// of the latter is that close to one half is the exact test made: x > q + 1/2 when
/// v_i^2 2^(2F + 2) > (2q + 1)^2 |v|^2. They are never equal: without a common factor of the v_i,
/// 2^(F + 1) would divide |v|; but where the squares of up to four integers sum to a multiple of 8,
/// all of them are even (modulo 8).
template <class Component, int B, int F, std::size_t N>
[[nodiscard]] constexpr std::optional<std::array<Component, N>> unit_vector(
    const std::array<Fixed<B, F>, N>& v) noexcept {
  static_assert(N <= 4 && Component::frac >= 1, "detent: ties are ruled out by the proof above");
  constexpr int frac = Component::frac;
  constexpr int guard = 61 - frac;  // so that a quotient has at most 62 bits
  int length = 0;
  for (const auto& c : v) length = std::max(length, bit_length(c.raw()));
  if (length == 0) return std::nullopt;

  using Magnitude = IntegerFor<std::max(detail::result_bits(B), 62)>;
  const int scale = 62 - length;
  std::array<Magnitude, N> magnitude;
  std::array<std::uint64_t, N> scaled;
  Wide<2> squared;
  for (std::size_t i = 0; i < N; ++i) {
    const auto raw = integer_cast<Magnitude>(v[i].raw());
    magnitude[i] = sign_of(raw) < 0 ? static_cast<Magnitude>(-raw) : raw;
    scaled[i] = static_cast<std::uint64_t>(integer_cast<std::int64_t>(
        scale >= 0 ? shift_left(magnitude[i], scale) : shift_right_floor(magnitude[i], -scale)));
    const auto square = multiply_words(scaled[i], scaled[i]);
    squared = squared + Wide<2>::from_words({square.low, square.high});
  }
  const std::uint64_t norm = square_root_floor(squared.word(1), squared.word(0));

  std::array<Component, N> unit;
  for (std::size_t i = 0; i < N; ++i) {
    const auto numerator = shift_left(integer_cast<Int128>(Wide<2>(scaled[i])), frac + guard);
    const auto quotient = static_cast<std::uint64_t>(integer_cast<std::int64_t>(
        divide_floor(numerator, integer_cast<Int128>(Wide<2>(norm))).quotient));
    std::uint64_t result = quotient >> guard;
    constexpr std::uint64_t half = std::uint64_t{1} << (guard - 1);
    const std::uint64_t fraction = quotient & (2 * half - 1);
    constexpr std::uint64_t margin = 8;  // the 4 of the bound above, and one for the floor
    if (fraction > half + margin) {
      ++result;
    } else if (fraction >= half - margin) {
      using Exact =
          IntegerFor<detail::result_bits(2 * std::max(detail::result_bits(B), 31) + 2 * frac + 5)>;
      Exact length_squared(0);
      for (const auto& m : magnitude) {
        length_squared = wrapping_add<Exact>(length_squared, wrapping_multiply<Exact>(m, m));
      }
      const auto odd = static_cast<std::int64_t>(2 * result + 1);
      const Exact left =
          shift_left(wrapping_multiply<Exact>(magnitude[i], magnitude[i]), 2 * frac + 2);
      const Exact right =
          wrapping_multiply<Exact>(wrapping_multiply<Exact>(odd, odd), length_squared);
      if (left > right) ++result;
    }
    const auto value = static_cast<std::int64_t>(result);
    unit[i] = Component::assume_raw(
        static_cast<typename Component::raw_type>(sign_of(v[i].raw()) < 0 ? -value : value));
  }
  return unit;
}

#if __STDC_HOSTED__
template <class Component, std::floating_point T, std::size_t N>
[[nodiscard]] constexpr std::optional<std::array<Component, N>> unit_vector(
    const std::array<T, N>& v) noexcept {
  T squared = 0;
  for (const T c : v) squared += c * c;
  if (!(squared > 0) || squared > std::numeric_limits<T>::max()) return std::nullopt;
  const T norm = std::sqrt(squared);
  std::array<Component, N> unit;
  for (std::size_t i = 0; i < N; ++i) unit[i] = v[i] / norm;
  return unit;
}
#endif

}  // namespace detent
