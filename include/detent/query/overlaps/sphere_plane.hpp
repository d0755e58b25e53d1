// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/point_plane.hpp"
#include "detent/shape/sphere.hpp"

namespace detent {

/// Whether `sphere` and `plane` share a point.
///
/// The length of the normal counts exactly as stored: (dot(n, center) - offset)^2 <= radius^2 n^2.
///
/// domain: every input; a negative radius is an empty sphere and overlaps nothing
/// exact:  yes or no exact; touching counts                  (tests/oracle/sphere_pairs.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Sphere<S, N>& sphere,
                                      const Plane<S, N>& plane) noexcept {
  return sphere.radius >= 0 && detail::within_reach(plane, sphere.center, sphere.radius);
}
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Plane<S, N>& plane,
                                      const Sphere<S, N>& sphere) noexcept {
  return overlaps(sphere, plane);
}

}  // namespace detent
