// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/point_ray.hpp"

namespace detent {

/// Whether `point` lies on `ray`, with the direction exactly as stored.
///
/// domain: every input; a ray with a negative max_distance has no points
/// exact:  yes or no exact                                       (tests/oracle/point_ray.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool contains(const Ray<S, N>& ray, const Vec<S, N>& point) noexcept {
  return detail::holds(ray, point);
}

}  // namespace detent
