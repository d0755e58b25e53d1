// SPDX-License-Identifier: MIT
#pragma once

// The counterparts of rounding.hpp for float and double: the operation itself, as the language
// and the platform round it. They let one source run in every scalar, and promise nothing.

#include <cmath>
#include <concepts>
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
