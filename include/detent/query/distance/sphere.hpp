// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/length.hpp"
#include "detent/shape/sphere.hpp"

namespace detent {

/// The distance from `point` to `sphere`, 0 inside.
///
/// units:  world units
/// domain: every input; clamped to the greatest scalar, which is the result for an empty sphere
/// exact:  rounded down, error in [0, 1) ULP                  (tests/oracle/point_sphere.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr S distance(const Sphere<S, N>& sphere, const Vec<S, N>& point) noexcept {
  if (sphere.radius < 0) return largest<S>;
  const auto squared = squared_distance(point, sphere.center);
  if (squared <= square(sphere.radius)) return S(0);
  return detail::less_radius<S>(sqrt_floor<detail::Length<S>>(squared), sphere.radius);
}

}  // namespace detent
