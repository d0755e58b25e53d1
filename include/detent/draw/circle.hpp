// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "detent/math/direction.hpp"
#include "detent/number/angle.hpp"

// Circles as polygons of 32 sides, from a table of sines.

namespace detent::detail {

/// The number of sides of a circle.
inline constexpr int circle_sides = 32;

/// The sines of the multiples of 1/32 turn in Q2.30, rounded to nearest.
inline constexpr auto circle_sines = [] {
  std::array<std::int32_t, std::size_t{circle_sides}> raw{};
  for (int i = 0; i < circle_sides; ++i) {
    raw[static_cast<std::size_t>(i)] =
        sin<Fixed<31, 30>>(Angle<q16_16>::turn(i, circle_sides)).raw();
  }
  return raw;
}();

/// The sine of `i` / 32 turn, for every `i` >= -32.
template <Scalar S>
[[nodiscard]] constexpr auto circle_sine(int i) noexcept {
  using Component = direction_component<S>;
  const auto raw = circle_sines[static_cast<std::size_t>((i + circle_sides) % circle_sides)];
  if constexpr (is_fixed<S>) {
    return nearest_to<Component>(Fixed<31, 30>::from_raw(raw));
  } else {
    return static_cast<Component>(raw) / static_cast<Component>(1 << 30);
  }
}
template <Scalar S>
[[nodiscard]] constexpr auto circle_cosine(int i) noexcept {
  return circle_sine<S>(i + circle_sides / 4);
}

/// The point at `i` / 32 turn from `u` towards `v` on the circle about `center`.
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<S, N> circle_point(const Vec<S, N>& center, const S& radius,
                                               const Direction<S, N>& u, const Direction<S, N>& v,
                                               int i) noexcept {
  return nearest_to<S>(center + (u * circle_cosine<S>(i) + v * circle_sine<S>(i)) * radius);
}

/// A direction perpendicular to `w`, up to rounding.
template <Scalar S>
[[nodiscard]] constexpr Direction<S, 2> perpendicular(const Direction<S, 2>& w) noexcept {
  return Direction<S, 2>::assume_unit({narrow_negative(w[1]), w[0]});
}
template <Scalar S>
[[nodiscard]] constexpr Direction<S, 3> perpendicular(const Direction<S, 3>& w) noexcept {
  int least = 0;
  for (int i = 1; i < 3; ++i) {
    if (abs(w[i]) < abs(w[least])) least = i;
  }
  return direction_of<S>(cross(w, Direction<S, 3>::along(least).vec())).value_or(w);
}

/// The direction perpendicular to two perpendicular ones.
template <Scalar S>
[[nodiscard]] constexpr Direction<S, 3> perpendicular(const Direction<S, 3>& u,
                                                      const Direction<S, 3>& v) noexcept {
  return direction_of<S>(cross(u, v.vec())).value_or(u);
}

}  // namespace detent::detail
