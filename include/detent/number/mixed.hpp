// SPDX-License-Identifier: MIT
#pragma once

// Operators on a `Fixed` and a built-in number: exact for integers, deleted for `float` and
// `double`. Operators without an exact result are deleted too; compilers show the deleted line.

#include <compare>
#include <concepts>
#include <type_traits>

#include "detent/number/fixed.hpp"

namespace detent {

/// The integer has all the bits of its type: x + 1 is wider than x + 1_q16_16.
template <int B, int F, std::integral Int>
[[nodiscard]] constexpr auto operator+(const Fixed<B, F>& x, Int n) noexcept {
  return x + detail::as_fixed(n);
}
template <int B, int F, std::integral Int>
[[nodiscard]] constexpr auto operator+(Int n, const Fixed<B, F>& x) noexcept {
  return detail::as_fixed(n) + x;
}
template <int B, int F, std::integral Int>
[[nodiscard]] constexpr auto operator-(const Fixed<B, F>& x, Int n) noexcept {
  return x - detail::as_fixed(n);
}
template <int B, int F, std::integral Int>
[[nodiscard]] constexpr auto operator-(Int n, const Fixed<B, F>& x) noexcept {
  return detail::as_fixed(n) - x;
}
template <int B, int F, std::integral Int>
[[nodiscard]] constexpr auto operator*(const Fixed<B, F>& x, Int n) noexcept {
  return x * detail::as_fixed(n);
}
template <int B, int F, std::integral Int>
[[nodiscard]] constexpr auto operator*(Int n, const Fixed<B, F>& x) noexcept {
  return detail::as_fixed(n) * x;
}

namespace detail {

template <class A, class B>
concept OneIsFixed = (is_fixed<A> && (is_fixed<B> || std::is_arithmetic_v<B>)) ||
                     (is_fixed<B> && std::is_arithmetic_v<A>);

/// An operand used with numbers of type T: integers become a `Fixed`, `float` or `double`.
template <class T, class A>
[[nodiscard]] constexpr auto as_operand(const A& a) noexcept {
  if constexpr (!std::integral<A>) {
    return a;
  } else if constexpr (is_fixed<T>) {
    return as_fixed(a);
  } else {
    return static_cast<T>(a);
  }
}

}  // namespace detail

// One line each, because compilers show the line with the name.
// clang-format off
template <class A, class B>
requires detail::OneIsFixed<A, B>
void operator/(const A&, const B&) = delete;  // detent: write quotient_nearest<T>(x, y) or half(x)
template <class A, int B, int F>
void operator/=(Fixed<B, F>&, const A&) = delete;  // detent: write x = quotient_nearest<T>(x, y)

template <int B, int F, std::floating_point D>
void operator+(const Fixed<B, F>&, D) = delete;  // detent: write 1.5_q16_16 or T::from_double(y)
template <int B, int F, std::floating_point D>
void operator+(D, const Fixed<B, F>&) = delete;  // detent: write 1.5_q16_16 or T::from_double(y)
template <int B, int F, std::floating_point D>
void operator-(const Fixed<B, F>&, D) = delete;  // detent: write 1.5_q16_16 or T::from_double(y)
template <int B, int F, std::floating_point D>
void operator-(D, const Fixed<B, F>&) = delete;  // detent: write 1.5_q16_16 or T::from_double(y)
template <int B, int F, std::floating_point D>
void operator*(const Fixed<B, F>&, D) = delete;  // detent: write 1.5_q16_16 or T::from_double(y)
template <int B, int F, std::floating_point D>
void operator*(D, const Fixed<B, F>&) = delete;  // detent: write 1.5_q16_16 or T::from_double(y)
template <int B, int F, std::floating_point D>
void operator+=(Fixed<B, F>&, D) = delete;  // detent: write 1.5_q16_16 or T::from_double(y)
template <int B, int F, std::floating_point D>
void operator-=(Fixed<B, F>&, D) = delete;  // detent: write 1.5_q16_16 or T::from_double(y)
template <int B, int F, std::floating_point D>
void operator*=(Fixed<B, F>&, D) = delete;  // detent: write 1.5_q16_16 or T::from_double(y)
template <int B, int F, std::floating_point D>
bool operator==(const Fixed<B, F>&, D) = delete;  // detent: write 1.5_q16_16 or T::from_double(y)
template <int B, int F, std::floating_point D>
std::strong_ordering
operator<=>(const Fixed<B, F>&, D) = delete;  // detent: write 1.5_q16_16 or T::from_double(y)
// clang-format on

}  // namespace detent
