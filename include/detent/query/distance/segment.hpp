// SPDX-License-Identifier: MIT
#pragma once

#include "detent/number/fraction.hpp"
#include "detent/shape/segment.hpp"

namespace detent {

namespace detail {

/// The squared length of a cross product, a number in 2D, that the caller knows to fit `Bits`.
template <int Bits, Number T>
[[nodiscard]] constexpr auto narrow_square(const T& x) noexcept {
  return narrow_product<Bits>(x, x);
}
template <int Bits, Number T, int N>
[[nodiscard]] constexpr auto narrow_square(const Vec<T, N>& x) noexcept {
  return narrow_dot<Bits>(x, x);
}

}  // namespace detail

/// The square of the distance from `point` to `segment`: |w x e|^2 / |e|^2 beside it, where w leads
/// from the start to the point and e along the segment.
///
/// domain: every input; equal ends make it one point
/// exact:  the fraction is the exact value                   (tests/oracle/point_segment.test.cpp)
/// source: Ericson, Real-Time Collision Detection, 5.1.2.1
template <Scalar S, int N>
[[nodiscard]] constexpr auto squared_distance(const Segment<S, N>& segment,
                                              const Vec<S, N>& point) noexcept {
  const auto edge = segment.end - segment.start;
  const auto from_start = point - segment.start;
  const auto along = dot(from_start, edge);
  const auto whole = squared_length(edge);
  using Under = decltype(squared_length(edge));
  using Over = decltype(whole * whole);  // |w x e|^2 <= |w|^2 |e|^2
  using Result = Fraction<Over, Under>;
  if (along <= 0) return Result{Over(squared_length(from_start)), Under(1)};
  if (along >= whole) return Result{Over(squared_distance(point, segment.end)), Under(1)};
  return Result{detail::narrow_square<bits_of<Over>>(cross(from_start, edge)), whole};
}

/// The distance from `point` to `segment`.
///
/// units:  world units
/// domain: every input; a distance beyond the greatest scalar is that
/// exact:  rounded down, error in [0, 1) ULP                 (tests/oracle/point_segment.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr S distance(const Segment<S, N>& segment, const Vec<S, N>& point) noexcept {
  return sqrt_floor<S>(squared_distance(segment, point));
}

}  // namespace detent
