// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "detent/number/filter/components.hpp"

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
/// They are never equal: after removing common factors of the m, 2^(Frac + 1) would divide |m|. But
/// if the squares of up to four integers sum to a multiple of 8, all of the integers are even
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

}  // namespace detail

/// The unit vector along `v`, or nothing for the zero vector.
///
/// exact:  each component is the exact one rounded to nearest    (tests/math/direction.test.cpp)
///
/// A component is compared exactly only if its share is so close to a midpoint that the error could
/// change the rounding.
template <class Component, int B, int F, std::size_t N>
[[nodiscard]] constexpr std::optional<std::array<Component, N>> unit_vector(
    const std::array<Fixed<B, F>, N>& v) noexcept {
  using Magnitude = IntegerFor<(std::max)(detail::result_bits(B), 62)>;
  const auto magnitude = detail::magnitudes<Magnitude>(v);
  if (magnitude == std::array<Magnitude, N>{}) return std::nullopt;
  const auto shares = detail::shares(magnitude);
  static_assert(detail::Share::frac - Component::frac >= 21, "detent: less than half a step");
  std::array<Component, N> unit;
  for (std::size_t i = 0; i < N; ++i) {
    const auto nearest = decide_nearest<Component>(Approximate{shares.value[i], shares.error});
    const auto share = or_exact(nearest, [&](const Component& upper) {
      const auto below = static_cast<std::uint64_t>(upper.raw()) - 1;
      const bool is_above = detail::is_above_half<B, Component::frac>(magnitude, i, below);
      return nearest_at_midpoint(upper, is_above ? 1 : -1);
    });
    unit[i] = detail::with_sign(share, is_negative(v[i].raw()));
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
