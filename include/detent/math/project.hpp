// SPDX-License-Identifier: MIT
#pragma once

#include "detent/math/direction.hpp"

// The parts of a vector along and across another one. Each component is one exact quotient, rounded
// once: project(v, onto) + reject(v, onto) may differ from v by one unit.

namespace detent {

namespace detail {

/// The bits of |v| |onto|^2, which bounds the numerators below: 3 sqrt(3) 2^3B for components of B
/// bits. For a direction `onto`, the bits of twice that: 2 sqrt(3) (1 + 2^-13)^3 2^B.
template <Number T>
inline constexpr int projection_bits = result_bits(3 * bits_of<T> + 3);
template <Scalar S>
inline constexpr int directed_bits = along_bits<S, S> + bits_of<direction_component<S>>;

template <int Bits, Scalar S, Number A, Number D, Number T, int N>
[[nodiscard]] constexpr Vec<S, N> part_along(const A& along, const D& squared,
                                             const Vec<T, N>& onto) noexcept {
  return make_vec<N>(
      [&](int i) { return quotient_nearest<S>(narrow_product<Bits>(along, onto[i]), squared); });
}

/// v - factor * (along / squared) * onto.
template <int Bits, Scalar S, Number A, Number D, Number T, int N>
[[nodiscard]] constexpr Vec<S, N> part_across(const Vec<S, N>& v, const A& along, const D& squared,
                                              const Vec<T, N>& onto) noexcept {
  return make_vec<N>([&](int i) {
    const auto numerator = narrow_difference<Bits>(narrow_product<Bits>(squared, v[i]),
                                                   narrow_product<Bits>(along, onto[i]));
    return quotient_nearest<S>(numerator, squared);
  });
}

}  // namespace detail

/// The part of `v` along `onto`: dot(v, onto) / |onto|^2 * onto.
///
/// domain: every vector; the zero vector for a zero `onto`
/// exact:  each component rounded to nearest, ties to even, and clamped
///         (tests/math/project.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<S, N> project(const Vec<S, N>& v, const Vec<S, N>& onto) noexcept {
  if (onto == Vec<S, N>{}) return {};
  constexpr int bits = detail::projection_bits<S>;
  return detail::part_along<bits, S>(dot(v, onto), squared_length(onto), onto);
}
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<S, N> project(const Vec<S, N>& v,
                                          const Direction<S, N>& onto) noexcept {
  constexpr int bits = detail::directed_bits<S>;
  return detail::part_along<bits, S>(dot(v, onto), squared_length(onto), onto.vec());
}

/// The part of `v` perpendicular to `onto`: v minus its projection.
///
/// domain: every vector; `v` itself for a zero `onto`
/// exact:  each component rounded to nearest, ties to even, and clamped
///         (tests/math/project.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<S, N> reject(const Vec<S, N>& v, const Vec<S, N>& onto) noexcept {
  if (onto == Vec<S, N>{}) return v;
  constexpr int bits = detail::projection_bits<S>;
  return detail::part_across<bits>(v, dot(v, onto), squared_length(onto), onto);
}
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<S, N> reject(const Vec<S, N>& v, const Direction<S, N>& onto) noexcept {
  constexpr int bits = detail::directed_bits<S>;
  return detail::part_across<bits>(v, dot(v, onto), squared_length(onto), onto.vec());
}

/// `v` mirrored in the plane (or line) through the origin with this normal, as a ball bounces.
///
/// exact: the mirror image across the plane of the normal as stored, each component rounded to
///        nearest, ties to even, and clamped                        (tests/math/project.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<S, N> reflect(const Vec<S, N>& v,
                                          const Direction<S, N>& normal) noexcept {
  constexpr int bits = detail::directed_bits<S>;
  const auto along = dot(v, normal);
  return detail::part_across<bits>(v, along + along, squared_length(normal), normal.vec());
}

/// `v` rotated counter-clockwise by a quarter turn, exactly.
template <Number T>
[[nodiscard]] constexpr auto perpendicular(const Vec<T, 2>& v) noexcept {
  using Turned = decltype(-v.y);
  return Vec<Turned, 2>{-v.y, Turned(v.x)};
}
template <Scalar S>
[[nodiscard]] constexpr Direction<S, 2> perpendicular(const Direction<S, 2>& d) noexcept {
  return Direction<S, 2>::assume_unit(
      narrow<bits_of<direction_component<S>>>(perpendicular(d.vec())));
}

/// The point that divides the segment from `a` to `b` as t : 1 - t.
///
/// domain: every t; beyond [0, 1] the point is on the extension of the segment
/// exact:  each component rounded to nearest, ties to even, and clamped
///         (tests/math/project.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<S, N> lerp(const Vec<S, N>& a, const Vec<S, N>& b, S t) noexcept {
  return nearest_to<S>(a + (b - a) * t);
}

}  // namespace detent
