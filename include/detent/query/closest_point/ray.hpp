// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/line.hpp"
#include "detent/shape/ray.hpp"

namespace detent {

/// The point of `ray` closest to `point`.
///
/// units:  world units
/// domain: every input; a ray without points gives `point`; coordinates are clamped to the scalar's
///         range
/// exact:  each coordinate is the exact one rounded to nearest, ties to even
///         (tests/oracle/point_ray.test.cpp)
/// source: Ericson, Real-Time Collision Detection, 5.1.2
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<S, N> closest_point(const Ray<S, N>& ray,
                                                const Vec<S, N>& point) noexcept {
  if (ray.max_distance < 0) return point;
  const auto along = dot(point - ray.origin, ray.direction);
  const auto whole = squared_length(ray.direction);
  if (along <= 0) return ray.origin;
  if (along >= ray.max_distance * whole) return point_at(ray, ray.max_distance);
  return detail::point_on_line(ray.origin, ray.direction.vec(), make_ratio_to_unit(along, whole));
}

}  // namespace detent
