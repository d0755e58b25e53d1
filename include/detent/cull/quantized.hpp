// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "detent/number/rounding.hpp"

namespace detent {

// Quantized 16-bit numbers, eight per 128-bit vector register: they rule out most of many shapes,
// with a known error. `float` and `double` are not quantized.

namespace detail {

template <Scalar S>
struct quantized_of {
  using length = S;
  using slope = S;
};
template <int Bits, int Frac>
struct quantized_of<Fixed<Bits, Frac>> {
  using length = Fixed<15, 0>;
  using slope = Fixed<15, 16>;
};

}  // namespace detail

/// A length in units of 2^k steps of the scalar.
template <Scalar S>
using quantized = typename detail::quantized_of<S>::length;

/// A number in [-1/2, 1/2).
template <Scalar S>
using quantized_slope = typename detail::quantized_of<S>::slope;

/// The least k for which lengths up to `size`, and a 32nd more, take at most 2^15 steps of 2^k.
template <int Bits, int Frac>
[[nodiscard]] constexpr int quantized_shift(const Fixed<Bits, Frac>& size) noexcept {
  const auto raw = size.raw();
  return (std::max)(0, bit_length(raw + shift_right_floor(raw, 5)) - 15);
}
/// `x` in steps of 2^shift, rounded down.
template <Scalar S, int Bits, int Frac>
[[nodiscard]] constexpr quantized<S> quantized_floor(const Fixed<Bits, Frac>& x,
                                                     int shift) noexcept {
  return detail::clamp_raw<quantized<S>>(shift_right_floor(x.raw(), shift));
}
/// x * slope rounded down: one multiplication that keeps the upper half.
[[nodiscard]] constexpr Fixed<15, 0> quantized_product(const Fixed<15, 0>& x,
                                                       const Fixed<15, 16>& slope) noexcept {
  const std::int32_t product = std::int32_t{x.raw()} * std::int32_t{slope.raw()};
  return Fixed<15, 0>::assume_raw(static_cast<std::int16_t>(product >> 16));
}
/// x / 2 rounded to nearest, for x in [-1, 1]; one step less than 1/2 for 1.
template <Scalar S, int Bits, int Frac>
[[nodiscard]] constexpr quantized_slope<S> quantized_half(const Fixed<Bits, Frac>& x) noexcept {
  return (std::max)(nearest_to<quantized_slope<S>>(half(x)),
                    narrow_negative(largest<quantized_slope<S>>));
}
/// |x| in the type of x, branchless; x must not be the lowest number.
template <int Frac>
[[nodiscard]] constexpr Fixed<15, Frac> quantized_abs(const Fixed<15, Frac>& x) noexcept {
  const std::int32_t raw = x.raw();
  DETENT_ASSERT(raw > lowest<Fixed<15, Frac>>.raw());
  return Fixed<15, Frac>::assume_raw(static_cast<std::int16_t>(raw < 0 ? -raw : raw));
}
/// `count` steps of the grid; for `float` and `double`, with coordinates up to `size`, more than
/// their error.
template <int Bits, int Frac>
[[nodiscard]] constexpr Fixed<15, 0> quantized_steps(int count, const Fixed<Bits, Frac>&) noexcept {
  return Fixed<15, 0>(count);
}
/// A bound for coordinates relative to the middle of a grid: they stay 200 steps below it, as they
/// are at most 31 / 32 * 2^14, and its sum with one of them fits 16 bits.
template <Scalar S>
inline constexpr quantized<S> quantized_limit = largest<S> / 4;
template <int Bits, int Frac>
inline constexpr Fixed<15, 0> quantized_limit<Fixed<Bits, Frac>> = Fixed<15, 0>(16128);

#if __STDC_HOSTED__
template <std::floating_point F>
[[nodiscard]] constexpr int quantized_shift(F) noexcept {
  return 0;
}
template <Scalar S, std::floating_point F>
[[nodiscard]] constexpr S quantized_floor(F x, int) noexcept {
  return x;
}
template <std::floating_point F>
[[nodiscard]] constexpr F quantized_product(F x, F slope) noexcept {
  return x * slope;
}
template <Scalar S, std::floating_point F>
[[nodiscard]] constexpr S quantized_half(F x) noexcept {
  return x / 2;
}
template <std::floating_point F>
[[nodiscard]] constexpr F quantized_abs(F x) noexcept {
  return x < 0 ? -x : x;
}
template <std::floating_point F>
[[nodiscard]] constexpr F quantized_steps(int count, F size) noexcept {
  return static_cast<F>(count) * size / 262144;
}
#endif

}  // namespace detent
