// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "detent/number/rounding.hpp"

namespace detent {

/// Whether the components are those of a unit vector: none beyond 1, and the length is 1 within two
/// steps of their grid (2^-29 for Q2.30, 2^-13 for Q2.14).
template <int B, int F, std::size_t N>
[[nodiscard]] constexpr bool is_unit(const std::array<Fixed<B, F>, N>& v) noexcept {
  using Length = Fixed<F + 1, F>;
  constexpr auto one = Length(1);
  constexpr auto step = Length::from_raw(1);
  constexpr auto shortest = one - step - step, longest = one + step + step;
  Fixed<2 * F + 2, 2 * F> squared;
  for (const auto& c : v) {
    if (c > 1 || c < -1) return false;
    squared = narrow<2 * F + 2>(squared + c * c);  // at most N <= 4
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

namespace detail {

/// Whether 2^Frac m[i] / |m| exceeds q + 1/2: whether m[i]^2 2^(2 Frac + 2) > (2q + 1)^2 |m|^2.
///
/// They are never equal. Otherwise, without a common factor of the m, 2^(Frac + 1) would divide
/// |m|. But if the squares of up to four integers sum to a multiple of 8, all of them are even
/// (modulo 8).
template <int Bits, int Frac, class Magnitude, std::size_t N>
[[nodiscard]] constexpr bool is_above_half(const std::array<Magnitude, N>& m, std::size_t i,
                                           std::uint64_t q) noexcept {
  static_assert(N <= 4 && Frac >= 1, "detent: ties are ruled out by the proof above");
  using Exact = IntegerFor<result_bits(2 * (std::max)(result_bits(Bits), 31) + 2 * Frac + 5)>;
  Exact squared(0);
  for (const auto& c : m) squared = wrapping_add<Exact>(squared, wrapping_multiply<Exact>(c, c));
  const auto odd = static_cast<std::int64_t>(2 * q + 1);
  return shift_left(wrapping_multiply<Exact>(m[i], m[i]), 2 * Frac + 2) >
         wrapping_multiply<Exact>(wrapping_multiply<Exact>(odd, odd), squared);
}

template <class Magnitude, int B, int F, std::size_t N>
[[nodiscard]] constexpr std::array<Magnitude, N> magnitudes(
    const std::array<Fixed<B, F>, N>& v) noexcept {
  std::array<Magnitude, N> result;
  for (std::size_t i = 0; i < N; ++i) {
    const auto raw = integer_cast<Magnitude>(v[i].raw());
    result[i] = is_negative(raw) ? wrapping_subtract<Magnitude>(Magnitude(0), raw) : raw;
  }
  return result;
}

/// 2^62 m[i] / |m|, off by less than 2^18 + 2^9; 0 where m is 0.
///
/// Every m[i] is scaled by the same power of two, the longest to 62 bits. Then the high words of
/// the squares lack less than 2^-54 of the whole, and scaling down drops less than 2^-59 of the
/// length. The rest is the error of `reciprocal_root`.
template <class Magnitude, std::size_t N>
[[nodiscard]] constexpr std::array<std::uint64_t, N> rough_shares(
    const std::array<Magnitude, N>& m) noexcept {
  Magnitude longest(0);
  for (const auto& c : m) longest = (std::max)(longest, c);
  const int scale = 62 - positive_bit_length(longest);
  std::array<std::uint64_t, N> shares;
  std::uint64_t squared = 1;  // at least 2^58 unless m is 0
  for (std::size_t i = 0; i < N; ++i) {
    shares[i] = integer_cast<std::uint64_t>(scale >= 0 ? shift_left(m[i], scale)
                                                       : shift_right_floor(m[i], -scale));
    squared += multiply_words(shares[i], shares[i]).high;
  }
  const int shift = std::countl_zero(squared) & ~1;
  const std::uint64_t reciprocal = reciprocal_root(squared << shift);
  for (auto& share : shares) share = multiply_words(share, reciprocal).high << (shift / 2);
  return shares;
}

}  // namespace detail

/// The unit vector along `v`, or nothing for the zero vector.
///
/// exact:  each component is the exact one rounded to nearest    (tests/math/direction.test.cpp)
///
/// Filter: a component is a share of `rough_shares`. It is compared exactly only where its fraction
/// is so close to one half that the error could change the rounding.
template <class Component, int B, int F, std::size_t N>
[[nodiscard]] constexpr std::optional<std::array<Component, N>> unit_vector(
    const std::array<Fixed<B, F>, N>& v) noexcept {
  using Magnitude = IntegerFor<(std::max)(detail::result_bits(B), 62)>;
  const auto magnitude = detail::magnitudes<Magnitude>(v);
  if (magnitude == std::array<Magnitude, N>{}) return std::nullopt;
  const auto shares = detail::rough_shares(magnitude);

  constexpr int guard = 62 - Component::frac;
  static_assert(guard >= 21, "detent: the margin has to be less than half a step");
  constexpr std::uint64_t half = std::uint64_t{1} << (guard - 1);
  constexpr std::uint64_t margin = std::uint64_t{1} << 19;
  std::array<Component, N> unit;
  for (std::size_t i = 0; i < N; ++i) {
    std::uint64_t rounded = (shares[i] + half) >> guard;
    const std::uint64_t next = (shares[i] + half + margin) >> guard;
    if (next != (shares[i] + half - margin) >> guard) [[unlikely]] {
      const bool is_above = detail::is_above_half<B, Component::frac>(magnitude, i, next - 1);
      rounded = is_above ? next : next - 1;
    }
    const auto value = static_cast<std::int64_t>(rounded);
    unit[i] = Component::assume_raw(
        static_cast<typename Component::raw_type>(is_negative(v[i].raw()) ? -value : value));
  }
  return unit;
}

#if __STDC_HOSTED__
template <class Component, std::floating_point T, std::size_t N>
[[nodiscard]] constexpr std::optional<std::array<Component, N>> unit_vector(
    const std::array<T, N>& v) noexcept {
  T squared = 0;
  for (const T c : v) squared += c * c;
  if (!(squared > 0) || squared > (std::numeric_limits<T>::max)()) return std::nullopt;
  const T norm = std::sqrt(squared);
  std::array<Component, N> unit;
  for (std::size_t i = 0; i < N; ++i) unit[i] = v[i] / norm;
  return unit;
}
#endif

}  // namespace detent
