// SPDX-License-Identifier: MIT
#pragma once

#include "detent/number/filter/ratio.hpp"
#include "detent/query/kernel/point_ray.hpp"

namespace detent {

/// The squared distance from `point` to `ray`: |d x w|^2 / |d|^2 where the point projects onto the
/// ray, with w from the origin to the point and d the direction exactly as stored.
///
/// domain: every input; a ray without points gives the greatest numerator over 1
/// exact:  the fraction is the exact value                       (tests/oracle/point_ray.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr auto squared_distance(const Ray<S, N>& ray,
                                              const Vec<S, N>& point) noexcept {
  return detail::squared_distance_from_ray(ray, point);
}

/// The distance from `point` to `ray`.
///
/// units:  world units
/// domain: every input; clamped to the greatest scalar, which is the result for a ray without
///         points
/// exact:  rounded down, error in [0, 1) ULP                     (tests/oracle/point_ray.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr S distance(const Ray<S, N>& ray, const Vec<S, N>& point) noexcept {
  if (ray.max_distance < 0) return largest<S>;
  // Avoids the exact fraction if it is wide and the point projects onto the ray.
  if constexpr (15 < bits_of<S>) {
    const auto from_origin = point - ray.origin;
    const auto along = dot(from_origin, ray.direction);
    const auto whole = squared_length(ray.direction);
    if (along > 0 && along < ray.max_distance * whole) {
      const auto side =
          decide_side_floor<S>(squared_length(from_origin), make_ratio_to_unit(along, whole));
      return or_exact(side, [&] { return sqrt_floor<S>(squared_distance(ray, point)); });
    }
  }
  return sqrt_floor<S>(squared_distance(ray, point));
}

}  // namespace detent
