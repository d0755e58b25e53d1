// SPDX-License-Identifier: MIT
#pragma once

#include "detent/dynamics/mass/properties.hpp"
#include "detent/number/pi.hpp"
#include "detent/shape/capsule.hpp"
#include "detent/shape/sphere.hpp"

namespace detent::detail {

/// The disc: twice the area is 2 pi r^2, the gyration r^2 / 2.
template <Scalar S>
[[nodiscard]] constexpr MassProperties<S, 2> solid_properties(const Sphere<S, 2>& disc,
                                                              const S& density) noexcept {
  using Formats = MassFormats<S>;
  if (disc.radius <= 0) return {};
  const auto squared = square(disc.radius);
  return properties_of<S, 2>(density, times_pi(squared + squared), make_vec<2>([&](int i) {
                               return typename Formats::Center(disc.center[i]);
                             }),
                             nearest_to<typename Formats::Gyration>(half(squared)));
}

/// The ball: 6 times the volume is 8 pi r^3, the gyration 2 r^2 / 5 about every axis.
template <Scalar S>
[[nodiscard]] constexpr MassProperties<S, 3> solid_properties(const Sphere<S, 3>& ball,
                                                              const S& density) noexcept {
  using Formats = MassFormats<S>;
  using Gyration = typename Formats::Gyration;
  if (ball.radius <= 0) return {};
  const auto squared = square(ball.radius);
  const auto about = quotient_nearest<Gyration>(squared + squared, as_operand<S>(5));
  return properties_of<S, 3>(
      density, times_pi(squared * ball.radius * as_operand<S>(8)),
      make_vec<3>([&](int i) { return typename Formats::Center(ball.center[i]); }),
      Symmetric<Gyration>{{about, about, about}, {}});
}

/// The center of a capsule and the length of its axis, which is rounded down to 2^-(Frac + 24).
template <Scalar S, int N>
[[nodiscard]] constexpr auto axis_of(const Capsule<S, N>& capsule) noexcept {
  using Formats = MassFormats<S>;
  struct Axis {
    typename Formats::Length length;
    Vec<typename Formats::Center, N> center;
  };
  return Axis{sqrt_floor<typename Formats::Length>(squared_distance(capsule.a, capsule.b)),
              nearest_to<typename Formats::Center>(half(capsule.a + capsule.b))};
}

/// The stadium with an axis of length l: twice the area is 2 r (2 l + pi r), and the gyration is
/// (2 l^3 + 24 r^2 l + pi (3 r l^2 + 6 r^3)) / (12 (2 l + pi r)).
template <Scalar S>
[[nodiscard]] constexpr MassProperties<S, 2> solid_properties(const Capsule<S, 2>& capsule,
                                                              const S& density) noexcept {
  using Formats = MassFormats<S>;
  if (capsule.radius <= 0) return {};
  const auto axis = axis_of(capsule);
  const auto r = capsule.radius;
  const auto l = axis.length;
  const auto whole = [](int n) { return as_operand<S>(n); };
  const auto width = l + l + times_pi(r);
  const auto spread = square(l) * l * whole(2) + square(r) * l * whole(24) +
                      times_pi(r * square(l) * whole(3) + r * square(r) * whole(6));
  return properties_of<S, 2>(
      density, (r + r) * width, axis.center,
      quotient_nearest<typename Formats::Gyration>(spread, width * whole(12)));
}

/// The capsule with an axis d of length l: 6 times the volume is 2 pi r^2 (3 l + 4 r). With
/// p = r^2 (15 l + 16 r) / (20 (3 l + 4 r)) and q = (l + r) (l + 3 r) / (4 l (3 l + 4 r)) the second
/// moments about its center, divided by its volume, are p I + q d d^T.
template <Scalar S>
[[nodiscard]] constexpr MassProperties<S, 3> solid_properties(const Capsule<S, 3>& capsule,
                                                              const S& density) noexcept {
  using Formats = MassFormats<S>;
  using Gyration = typename Formats::Gyration;
  if (capsule.radius <= 0) return {};
  if (capsule.a == capsule.b) {
    return solid_properties(Sphere<S, 3>{capsule.a, capsule.radius}, density);
  }
  const auto axis = axis_of(capsule);
  const auto r = capsule.radius;
  const auto l = axis.length;
  const auto d = capsule.b - capsule.a;
  const auto whole = [](int n) { return as_operand<S>(n); };
  const auto length = l * whole(3) + r * whole(4);
  const auto twice_p = square(r) * (l * whole(15) + r * whole(16)) * l * whole(2);
  const auto q = (l + r) * (l + r * whole(3)) * whole(5);
  const auto unit = length * l * whole(20);
  const auto gyration = Symmetric<Gyration>{
      make_vec<3>([&](int i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        return quotient_nearest<Gyration>(twice_p + q * (square(d[j]) + square(d[k])), unit);
      }),
      make_vec<3>([&](int i) {
        return quotient_nearest<Gyration>(-(q * (d[(i + 1) % 3] * d[(i + 2) % 3])), unit);
      })};
  const auto squared = square(r);
  return properties_of<S, 3>(density, times_pi((squared + squared) * length), axis.center,
                             gyration);
}

}  // namespace detent::detail
