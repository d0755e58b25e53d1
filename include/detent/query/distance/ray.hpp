// SPDX-License-Identifier: MIT
#pragma once

#include "detent/math/width.hpp"
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

namespace detail {

/// `distance` to a ray, without a filter.
template <Scalar S, int N>
[[nodiscard]] DETENT_OUTLINE constexpr S exact_distance(const Ray<S, N>& ray,
                                                        const Vec<S, N>& point) noexcept {
  const auto squared = squared_distance(ray, point);
  if (squared.denominator == 1) return sqrt_floor<S>(squared.numerator);
  return sqrt_floor<S>(squared);
}

}  // namespace detail

/// The distance from `point` to `ray`.
///
/// units:  world units
/// domain: every input; clamped to the greatest scalar, which is the result for a ray without
///         points
/// exact:  rounded down, error in [0, 1) ULP                       (tests/oracle/point_ray.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr S distance(const Ray<S, N>& ray, const Vec<S, N>& point) noexcept {
  if (ray.max_distance < 0) return largest<S>;
  if constexpr (is_fixed<S> && filter_pays<S>) {
    using Component = direction_component<S>;
    // No direction has a squared length below this.
    constexpr auto shortest = Component::from_raw(Component(1).raw() - 4);
    const auto from_origin = point - ray.origin;
    if (fits<30>(from_origin)) [[likely]] {
      const auto along = narrow_dot<61>(from_origin, ray.direction.vec());
      if (along < ray.max_distance * shortest) [[likely]] {
        const auto distance =
            decide_line_distance<S>(narrow_dot<62>(from_origin, from_origin), along,
                                    narrow<61>(squared_length(ray.direction)));
        if (distance.is_sure) [[likely]]
          return distance.value;
      }
    }
    return detail::exact_distance(ray, point);
  } else {
    return sqrt_floor<S>(squared_distance(ray, point));
  }
}

}  // namespace detent
