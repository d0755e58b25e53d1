// SPDX-License-Identifier: MIT
#pragma once

#include "detent/math/components.hpp"
#include "detent/number/fraction.hpp"
#include "detent/query/kernel/point_segment.hpp"
#include "detent/shape/ray.hpp"

namespace detent::detail {

/// Whether `point` lies on `ray`, with the direction exactly as stored.
template <Scalar S, int N>
[[nodiscard]] constexpr bool holds(const Ray<S, N>& ray, const Vec<S, N>& point) noexcept {
  const auto from_origin = point - ray.origin;
  if (!are_parallel(ray.direction, from_origin)) return false;
  const int i = longest_axis(ray.direction.vec());
  const auto distance = make_fraction(from_origin[i], ray.direction[i]);
  return distance.numerator >= 0 && distance <= ray.max_distance;
}

/// The squared distance from `point` to `ray`; from a ray without points, the greatest numerator
/// over 1.
template <Scalar S, int N>
[[nodiscard]] constexpr auto squared_distance_from_ray(const Ray<S, N>& ray,
                                                       const Vec<S, N>& point) noexcept {
  const auto from_origin = point - ray.origin;
  const auto along = dot(from_origin, ray.direction);
  const auto whole = squared_length(ray.direction);
  // The closest point is no farther than the origin, so |w|^2 |d|^2 bounds every numerator.
  constexpr int bits = 2 * along_bits<S, decltype(S() - S())>;
  using Over = decltype(narrow_product<bits>(along, along));
  using Under = decltype(squared_length(ray.direction));
  using Result = Fraction<Over, Under>;
  if (ray.max_distance < 0) return Result{largest<Over>, Under(1)};
  if (along <= 0) return Result{Over(squared_length(from_origin)), Under(1)};
  if (along >= ray.max_distance * whole) {
    const auto from_end = from_origin - ray.max_distance * ray.direction.vec();
    return Result{narrow_dot<bits>(from_end, from_end), Under(1)};
  }
  return Result{narrow_square<bits>(cross(ray.direction, from_origin)), whole};
}

/// Whether `point` is within `reach` >= 0 of `ray`.
template <Scalar S, int N>
[[nodiscard]] constexpr bool within_reach(const Ray<S, N>& ray, const Vec<S, N>& point,
                                          const S& reach) noexcept {
  return squared_distance_from_ray(ray, point) <= square(reach);
}

}  // namespace detent::detail
