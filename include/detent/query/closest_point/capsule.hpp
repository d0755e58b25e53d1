// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "detent/query/closest_point/sphere.hpp"
#include "detent/query/contains/capsule.hpp"

namespace detent {

namespace detail {

/// The unit vector along `v`, which is not 0, with each component rounded to nearest.
template <Number Component, Number T, int N>
[[nodiscard]] constexpr std::array<Component, N> unit_along(const Vec<T, N>& v) noexcept {
  std::array<T, N> components;
  for (int i = 0; i < N; ++i) components[static_cast<std::size_t>(i)] = v[i];
  return *unit_vector<Component>(components);
}

/// Beside its axis, a capsule's closest point is the axis point, over / whole, plus `radius` along
/// `outward`; |outward|^2 = whole * square. One coordinate of it:
template <Scalar S, Number Over, Number Whole, Number Outward, Number Square>
struct CapsuleSide {
  Over over;
  Whole whole;
  Outward outward;
  S radius;
  Square square;

  /// The sign of the exact coordinate less x: with d = x whole - over, that of
  /// radius outward / (|outward|) - d / whole, whose parts are compared by their squares times
  /// whole: (radius outward)^2 / square and d^2 / whole.
  template <Number T>
  [[nodiscard]] constexpr int sign_of_difference(const T& x) const noexcept {
    const auto short_of = x * whole - over;
    const auto step = T(radius) * outward;
    const int step_sign = (step > 0) - (step < 0);
    const int short_sign = (short_of > 0) - (short_of < 0);
    if (step_sign != short_sign) return step_sign > short_sign ? 1 : -1;
    const Fraction left{step * step, square};
    const Fraction right{short_of * short_of, whole};
    return step_sign * ((right < left) - (left < right));
  }

  /// The exact coordinate rounded to nearest, ties to even.
  ///
  /// The axis point is off by 2^-17 ULP, and the radius, below 2^31 ULP, takes a unit vector that
  /// is off by 2^-47 (16 bits: 2^15 and 2^-31). Together less than the margin, 2^-15 ULP, so only
  /// within it of a half is the exact coordinate asked.
  template <Number Unit>
  [[nodiscard]] constexpr S nearest(const Unit& direction) const noexcept {
    const auto sum = quotient_nearest<finer<S, 16>>(over, whole) + radius * direction;
    if constexpr (!is_fixed<S>) {
      return nearest_to<S>(sum);
    } else {
      using Half = finer<S, 1>;
      const S below = floor_to<S>(sum);
      const Half half = narrow<bits_of<Half>>(Half(below) + Half::from_raw(1));
      constexpr auto margin = finer<S, 15>::from_raw(1);
      const auto beyond = sum - half;
      const int side = beyond > margin ? 1 : beyond < -margin ? -1 : sign_of_difference(half);
      const bool is_odd = (below.raw() & 1) != 0;
      return side > 0 || (side == 0 && is_odd) ? nearest_to<S>(half + Half::from_raw(1)) : below;
    }
  }
};

template <Scalar S, Number Over, Number Whole, Number Outward, Number Square>
CapsuleSide(Over, Whole, Outward, S, Square) -> CapsuleSide<S, Over, Whole, Outward, Square>;

}  // namespace detail

/// The point of `capsule` that is closest to `point`, which is `point` itself inside.
///
/// units:  world units
/// domain: every input; an empty capsule has no point and gives `point`
/// exact:  each coordinate is the exact one rounded to nearest, ties to even
///         (tests/oracle/point_capsule.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<S, N> closest_point(const Capsule<S, N>& capsule,
                                                const Vec<S, N>& point) noexcept {
  const auto& [a, b, radius] = capsule;
  if (radius < 0 || contains(capsule, point)) return point;
  const auto axis = b - a;
  const auto from_a = point - a;
  const auto along = dot(from_a, axis);
  const auto whole = squared_length(axis);
  if (along <= 0) return closest_point(Sphere{a, radius}, point);
  if (along >= whole) return closest_point(Sphere{b, radius}, point);

  const auto outward = from_a * whole - axis * along;
  const auto direction = detail::unit_along<finer<direction_component<S>, 16>>(outward);
  const auto square = detail::narrow_square<bits_of<decltype(whole * whole)>>(cross(from_a, axis));
  Vec<S, N> closest;
  for (int i = 0; i < N; ++i) {
    const detail::CapsuleSide side{a[i] * whole + axis[i] * along, whole, outward[i], radius,
                                   square};
    closest[i] = side.nearest(direction[static_cast<std::size_t>(i)]);
  }
  return closest;
}

}  // namespace detent
