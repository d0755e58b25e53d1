// SPDX-License-Identifier: MIT
#pragma once

// The counterparts of rounding.hpp for float and double: plain operations, rounded as the platform
// does. They let the same source run in every scalar, and promise nothing.

#include <cmath>
#include <concepts>
#include <limits>
#include <type_traits>

#include "detent/number/require_cxx20.hpp"

namespace detent {

template <class T, std::floating_point F>
[[nodiscard]] constexpr T floor_to(F x) noexcept {
  return static_cast<T>(x);
}
template <class T, std::floating_point F>
[[nodiscard]] constexpr T ceil_to(F x) noexcept {
  return static_cast<T>(x);
}
template <class T, std::floating_point F>
[[nodiscard]] constexpr T nearest_to(F x) noexcept {
  return static_cast<T>(x);
}
template <class T, std::floating_point F>
[[nodiscard]] constexpr T saturate_to(F x) noexcept {
  return static_cast<T>(x);
}

namespace detail {

/// `x` without its fraction, clamped to the range of T; 0 for a NaN.
template <std::integral T, std::floating_point F>
[[nodiscard]] constexpr T truncate_to(F x) noexcept {
  using Limits = std::numeric_limits<T>;
  constexpr F half_end = static_cast<F>(T(1) << (Limits::digits - 1));
  if (x != x) return T(0);
  if (x >= 2 * half_end) return (Limits::max)();
  if (x <= (std::is_signed_v<T> ? -2 * half_end : F{})) return (Limits::min)();
  return static_cast<T>(x);
}

}  // namespace detail

/// Built-in integers: rounded as the name says and clamped; 0 for a NaN.
template <std::integral T, std::floating_point F>
[[nodiscard]] constexpr T floor_to(F x) noexcept {
  const T whole = detail::truncate_to<T>(x);
  return static_cast<F>(whole) > x && whole != (std::numeric_limits<T>::min)()
             ? static_cast<T>(whole - 1)
             : whole;
}
template <std::integral T, std::floating_point F>
[[nodiscard]] constexpr T ceil_to(F x) noexcept {
  const T whole = detail::truncate_to<T>(x);
  return static_cast<F>(whole) < x && whole != (std::numeric_limits<T>::max)()
             ? static_cast<T>(whole + 1)
             : whole;
}
/// Ties go to the even integer.
template <std::integral T, std::floating_point F>
[[nodiscard]] constexpr T nearest_to(F x) noexcept {
  const T below = floor_to<T>(x), above = ceil_to<T>(x);
  const F down = x - static_cast<F>(below), up = static_cast<F>(above) - x;
  return up < down || (up == down && below % 2 != 0) ? above : below;
}
template <std::integral T, std::floating_point F>
[[nodiscard]] constexpr T saturate_to(F x) noexcept {
  return nearest_to<T>(x);
}

template <int Bits, std::floating_point F>
[[nodiscard]] constexpr F narrow(F x) noexcept {
  return x;
}
template <std::floating_point F>
[[nodiscard]] constexpr F narrow_negative(F x) noexcept {
  return -x;
}
template <int Bits, std::floating_point F>
[[nodiscard]] constexpr F narrow_product(F a, F b) noexcept {
  return a * b;
}
template <int Bits, std::floating_point F>
[[nodiscard]] constexpr F narrow_sum(F a, F b) noexcept {
  return a + b;
}
template <int Bits, std::floating_point F>
[[nodiscard]] constexpr F narrow_difference(F a, F b) noexcept {
  return a - b;
}
template <int Bits, std::floating_point F>
[[nodiscard]] constexpr F scale_up(F x, int) noexcept {
  return x;
}
template <std::floating_point F>
[[nodiscard]] constexpr int headroom(F) noexcept {
  return 0;
}
template <class T, std::floating_point F>
[[nodiscard]] constexpr T quotient_floor(F n, F d) noexcept {
  return static_cast<T>(n / d);
}
template <class T, std::floating_point F>
[[nodiscard]] constexpr T quotient_nearest(F n, F d) noexcept {
  return static_cast<T>(n / d);
}
template <class T, std::floating_point F>
[[nodiscard]] constexpr T sqrt_floor(F x) noexcept {
  return static_cast<T>(std::sqrt(x));
}
template <class T, std::floating_point F>
[[nodiscard]] constexpr T sqrt_ceil(F x) noexcept {
  return static_cast<T>(std::sqrt(x));
}
template <std::floating_point F>
[[nodiscard]] constexpr F half(F x) noexcept {
  return x / 2;
}
template <std::floating_point F>
[[nodiscard]] constexpr F abs(F x) noexcept {
  if (std::is_constant_evaluated()) return x < 0 ? -x : x;
  return std::abs(x);  // without a branch
}
template <std::floating_point F>
[[nodiscard]] constexpr F narrow_abs(F x) noexcept {
  return abs(x);
}

}  // namespace detent
