// SPDX-License-Identifier: MIT
#pragma once

#include "detent/number/filter/unit_length.hpp"
#include "detent/query/kernel/point_plane.hpp"

namespace detent {

/// The squared distance from `point` to `plane`: (dot(n, point) - offset)^2 / dot(n, n), with the
/// normal n exactly as stored.
///
/// domain: every input
/// exact:  the fraction is the exact value                     (tests/oracle/point_plane.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr auto squared_distance(const Plane<S, N>& plane,
                                              const Vec<S, N>& point) noexcept {
  const auto height = detail::height_above(plane, point);
  return Fraction{height * height, squared_length(plane.normal)};
}

/// The distance from `point` to `plane`, on either side of it.
///
/// units:  world units
/// domain: every input; clamped to the greatest scalar
/// exact:  rounded down, error in [0, 1) ULP                   (tests/oracle/point_plane.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr S distance(const Plane<S, N>& plane, const Vec<S, N>& point) noexcept {
  if constexpr (!is_fixed<S>) {
    return sqrt_floor<S>(squared_distance(plane, point));
  } else {
    return divide_by_length<S>(detail::height_above(plane, point), squared_length(plane.normal));
  }
}

}  // namespace detent
