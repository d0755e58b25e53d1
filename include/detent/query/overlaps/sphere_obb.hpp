// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/point_obb.hpp"
#include "detent/shape/sphere.hpp"

namespace detent {

/// Whether `sphere` and `box` share a point.
///
/// The box is its slabs, {x : |dot(axis(i), x - center)| <= half_extents[i]}, with the axes exactly
/// as stored. The sphere's radius is measured in their frame: see `squared_distance`.
///
/// domain: every input; an empty sphere or box overlaps nothing
/// exact:  yes or no exact; touching counts                  (tests/oracle/sphere_pairs.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Sphere<S, N>& sphere, const Obb<S, N>& box) noexcept {
  return sphere.radius >= 0 && detail::within_reach(box, sphere.center, sphere.radius);
}
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Obb<S, N>& box, const Sphere<S, N>& sphere) noexcept {
  return overlaps(sphere, box);
}

}  // namespace detent
