// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <concepts>
#include <type_traits>

#include "detent/number/scalar.hpp"

// Names are in parentheses because <windows.h> defines min and max as macros. The overloads for two
// numbers of one type are better matches than std::min, std::max and std::clamp where a user's
// `using namespace std` makes both visible.

namespace detent {

namespace detail {

/// How many bits a `Fixed<B, F>` needs on the grid of 2^-Frac.
template <int B, int F, int Frac>
inline constexpr int bits_on_grid = fills_container(B) ? B + Frac - F : result_bits(B + Frac - F);

template <class A, class B>
struct common_fixed_of;
template <int Bits1, int Frac1, int Bits2, int Frac2>
struct common_fixed_of<Fixed<Bits1, Frac1>, Fixed<Bits2, Frac2>> {
  static constexpr int frac = (std::max)(Frac1, Frac2);
  using type =
      Fixed<(std::max)(bits_on_grid<Bits1, Frac1, frac>, bits_on_grid<Bits2, Frac2, frac>), frac>;
};

/// Whether some of the types are `Fixed` and all others are built-in numbers, at least one of each.
template <class... T>
concept FixedAndBuiltIn = (is_fixed<T> || ...) && (std::is_arithmetic_v<T> || ...) &&
                          ((is_fixed<T> || std::is_arithmetic_v<T>)&&...);

}  // namespace detail

/// The narrowest type to which both types convert.
template <class A, class B>
using common_fixed = typename detail::common_fixed_of<A, B>::type;

/// The lesser of two numbers, exactly, in a type that holds both.
template <class A, class B>
[[nodiscard]] constexpr common_fixed<A, B>(min)(const A& a, const B& b) noexcept {
  using T = common_fixed<A, B>;
  return b < a ? T(b) : T(a);
}
template <Number T>
[[nodiscard]] constexpr T(min)(const T& a, const T& b) noexcept {
  return b < a ? b : a;
}

/// The greater of two numbers, exactly, in a type that holds both.
template <class A, class B>
[[nodiscard]] constexpr common_fixed<A, B>(max)(const A& a, const B& b) noexcept {
  using T = common_fixed<A, B>;
  return a < b ? T(b) : T(a);
}
template <Number T>
[[nodiscard]] constexpr T(max)(const T& a, const T& b) noexcept {
  return a < b ? b : a;
}

/// `x` clamped to [low, high], exactly. The result has the type that holds both ends; if the grid
/// of `x` is finer, it has that grid and as many bits before the point.
///
/// domain: low <= high, which is asserted; otherwise the result is one of the two ends
template <int B, int F, int LowBits, int LowFrac, int HighBits, int HighFrac>
[[nodiscard]] constexpr auto(clamp)(const Fixed<B, F>& x, const Fixed<LowBits, LowFrac>& low,
                                    const Fixed<HighBits, HighFrac>& high) noexcept {
  using Ends = common_fixed<Fixed<LowBits, LowFrac>, Fixed<HighBits, HighFrac>>;
  constexpr int frac = (std::max)(F, Ends::frac);
  using T = Fixed<detail::bits_on_grid<Ends::bits, Ends::frac, frac>, frac>;
  DETENT_ASSERT(low <= high);
  if (x < low) return T(low);
  if (high < x) return T(high);
  return T::assume_raw(detail::aligned_raw<typename T::raw_type, frac>(x));
}
template <int B, int F>
[[nodiscard]] constexpr Fixed<B, F>(clamp)(const Fixed<B, F>& x, const Fixed<B, F>& low,
                                           const Fixed<B, F>& high) noexcept {
  DETENT_ASSERT(low <= high);
  return x < low ? low : high < x ? high : x;
}
template <std::floating_point Float>
[[nodiscard]] constexpr Float(clamp)(const Float& x, const Float& low, const Float& high) noexcept {
  return x < low ? low : high < x ? high : x;
}

// One line each, because compilers show the line with the name.
// clang-format off
template <class A, class B>
requires detail::FixedAndBuiltIn<A, B>
void(min)(const A&, const B&) = delete;  // detent: write the built-in number as 1_q16_16 or T(n)
template <class A, class B>
requires detail::FixedAndBuiltIn<A, B>
void(max)(const A&, const B&) = delete;  // detent: write the built-in number as 1_q16_16 or T(n)
template <class A, class B, class C>
requires detail::FixedAndBuiltIn<A, B, C>
void(clamp)(const A&, const B&, const C&) = delete;  // detent: write the ends as 1_q16_16 or T(n)
// clang-format on

}  // namespace detent
