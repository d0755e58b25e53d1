// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/parallel.hpp"
#include "detent/shape/ray.hpp"

namespace detent {

/// Whether `point` lies on `ray`, with the direction exactly as stored.
///
/// domain: every input; a ray with a negative max_distance has no points
/// exact:  yes or no exact                                       (tests/oracle/point_ray.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool contains(const Ray<S, N>& ray, const Vec<S, N>& point) noexcept {
  const auto from_origin = point - ray.origin;
  if (!detail::are_parallel(ray.direction, from_origin)) return false;
  const int i = detail::longest_axis(ray.direction.vec());
  const auto distance = make_fraction(from_origin[i], ray.direction[i]);
  return distance.numerator >= 0 && distance <= ray.max_distance;
}

}  // namespace detent
