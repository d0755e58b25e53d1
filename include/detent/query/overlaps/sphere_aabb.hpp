// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/point_aabb.hpp"
#include "detent/shape/sphere.hpp"

namespace detent {

/// Whether `sphere` and `box` share a point.
///
/// They overlap if the point of the box closest to the center is in the sphere.
///
/// domain: every input; an empty sphere or box overlaps nothing
/// exact:  yes or no exact; touching counts                  (tests/oracle/sphere_pairs.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Sphere<S, N>& sphere, const Aabb<S, N>& box) noexcept {
  return sphere.radius >= 0 && detail::within_reach(box, sphere.center, sphere.radius);
}
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Aabb<S, N>& box, const Sphere<S, N>& sphere) noexcept {
  return overlaps(sphere, box);
}

}  // namespace detent
