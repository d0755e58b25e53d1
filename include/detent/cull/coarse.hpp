// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "detent/number/rounding.hpp"

namespace detent {

// Quantized numbers of 16 bits, eight to a vector register of 128 bits: they rule out most of many
// shapes, with a known error. `float` and `double` are not quantized.

namespace detail {

template <Scalar S>
struct coarse_of {
  using length = S;
  using slope = S;
};
template <int Bits, int Frac>
struct coarse_of<Fixed<Bits, Frac>> {
  using length = Fixed<15, 0>;
  using slope = Fixed<15, 16>;
};

}  // namespace detail

/// A length in units of 2^k steps of the scalar.
template <Scalar S>
using coarse = typename detail::coarse_of<S>::length;

/// A number in [-1/2, 1/2).
template <Scalar S>
using coarse_slope = typename detail::coarse_of<S>::slope;

/// The least k for which lengths up to `size`, and a 32nd more, take at most 2^15 steps of 2^k.
template <int Bits, int Frac>
[[nodiscard]] constexpr int coarse_shift(const Fixed<Bits, Frac>& size) noexcept {
  const auto raw = size.raw();
  return (std::max)(0, bit_length(raw + shift_right_floor(raw, 5)) - 15);
}
/// `x` in steps of 2^shift, rounded down.
template <Scalar S, int Bits, int Frac>
[[nodiscard]] constexpr coarse<S> coarse_floor(const Fixed<Bits, Frac>& x, int shift) noexcept {
  return detail::clamp_raw<coarse<S>>(shift_right_floor(x.raw(), shift));
}
/// x * slope rounded down: one multiplication that keeps the upper half.
[[nodiscard]] constexpr Fixed<15, 0> coarse_product(const Fixed<15, 0>& x,
                                                    const Fixed<15, 16>& slope) noexcept {
  const std::int32_t product = std::int32_t{x.raw()} * std::int32_t{slope.raw()};
  return Fixed<15, 0>::assume_raw(static_cast<std::int16_t>(product >> 16));
}
/// x / 2 rounded to nearest, for x in [-1, 1]; one step less than 1/2 for 1.
template <Scalar S, int Bits, int Frac>
[[nodiscard]] constexpr coarse_slope<S> coarse_half(const Fixed<Bits, Frac>& x) noexcept {
  return (std::max)(nearest_to<coarse_slope<S>>(half(x)),
                    narrow_negative(largest<coarse_slope<S>>));
}
/// |x| in the type of x, branchless; x must not be the lowest number.
template <int Frac>
[[nodiscard]] constexpr Fixed<15, Frac> coarse_abs(const Fixed<15, Frac>& x) noexcept {
  const std::int32_t raw = x.raw();
  DETENT_ASSERT(raw > lowest<Fixed<15, Frac>>.raw());
  return Fixed<15, Frac>::assume_raw(static_cast<std::int16_t>(raw < 0 ? -raw : raw));
}
/// `count` steps of the grid; for `float` and `double`, whose coordinates are at most `size`, more
/// than their error.
template <int Bits, int Frac>
[[nodiscard]] constexpr Fixed<15, 0> coarse_steps(int count, const Fixed<Bits, Frac>&) noexcept {
  return Fixed<15, 0>(count);
}
/// A bound for coordinates relative to the middle of a grid: they stay 200 steps below it, as they
/// are at most 31 / 32 * 2^14, and its sum with one of them fits 16 bits.
template <Scalar S>
inline constexpr coarse<S> coarse_limit = largest<S> / 4;
template <int Bits, int Frac>
inline constexpr Fixed<15, 0> coarse_limit<Fixed<Bits, Frac>> = Fixed<15, 0>(16128);

#if __STDC_HOSTED__
template <std::floating_point F>
[[nodiscard]] constexpr int coarse_shift(F) noexcept {
  return 0;
}
template <Scalar S, std::floating_point F>
[[nodiscard]] constexpr S coarse_floor(F x, int) noexcept {
  return x;
}
template <std::floating_point F>
[[nodiscard]] constexpr F coarse_product(F x, F slope) noexcept {
  return x * slope;
}
template <Scalar S, std::floating_point F>
[[nodiscard]] constexpr S coarse_half(F x) noexcept {
  return x / 2;
}
template <std::floating_point F>
[[nodiscard]] constexpr F coarse_abs(F x) noexcept {
  return x < 0 ? -x : x;
}
template <std::floating_point F>
[[nodiscard]] constexpr F coarse_steps(int count, F size) noexcept {
  return static_cast<F>(count) * size / 262144;
}
#endif

}  // namespace detent
