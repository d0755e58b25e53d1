// SPDX-License-Identifier: MIT
#pragma once

#include "detent/math/direction.hpp"
#include "detent/number/arc.hpp"

namespace detent {

namespace detail {

/// |u|^2 |v|^2 - dot(u, v)^2 for any dimension, exactly: the square of the area that u and v span.
/// The caller must prove that |u|^2 |v|^2 fits `Bits`.
///
/// source: Lagrange's identity
template <int Bits, Number A, Number B, int N>
[[nodiscard]] constexpr auto squared_area(const Vec<A, N>& u, const Vec<B, N>& v) noexcept {
  const auto square = [&](int i, int j) {
    const auto area = cross(Vec{u[i], u[j]}, Vec{v[i], v[j]});
    return narrow_product<Bits>(area, area);
  };
  auto sum = square(0, 1);
  for (int i = 0; i < N; ++i) {
    for (int j = (i == 0 ? 2 : i + 1); j < N; ++j) sum = narrow_sum<Bits>(sum, square(i, j));
  }
  return sum;
}

}  // namespace detail

/// The angle between two vectors, in [0, 1/2] turn.
///
/// domain: every pair of vectors; 0 if one of them is the zero vector
/// exact:  off by less than 0.5 + 2^-28 units of 2^-32 turn; a multiple of an eighth of a turn is
///         exact                                              (tests/math/angle_between.test.cpp)
/// source: atan2(|u x v|, dot(u, v)): no division, and no arc cosine, which is inaccurate near 0
template <Scalar S, int N>
[[nodiscard]] constexpr Angle<S> angle_between(const Vec<S, N>& u, const Vec<S, N>& v) noexcept {
  // |u|^2 |v|^2 <= (3 * 2^2B)^2
  constexpr int bits = detail::result_bits(4 * bits_of<S> + 4);
  return angle_of_arc<S>(detail::squared_area<bits>(u, v), dot(u, v));
}

/// The angle between two directions as stored, as exact as between vectors.
template <Scalar S, int N>
[[nodiscard]] constexpr Angle<S> angle_between(const Direction<S, N>& u,
                                               const Direction<S, N>& v) noexcept {
  constexpr int bits = 2 * detail::cosine_bits<S>;  // (1 + 2^-13)^4 < 2
  return angle_of_arc<S>(detail::squared_area<bits>(u.vec(), v.vec()), dot(u, v));
}

}  // namespace detent
