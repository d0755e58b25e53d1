// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/point_capsule.hpp"
#include "detent/shape/sphere.hpp"

namespace detent {

/// Whether `sphere` and `capsule` share a point.
///
/// domain: every input; a shape with a negative radius is empty and overlaps nothing
/// exact:  yes or no exact; touching counts                  (tests/oracle/sphere_edges.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Sphere<S, N>& sphere,
                                      const Capsule<S, N>& capsule) noexcept {
  return sphere.radius >= 0 && detail::within_reach(capsule, sphere.center, sphere.radius);
}
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Capsule<S, N>& capsule,
                                      const Sphere<S, N>& sphere) noexcept {
  return overlaps(sphere, capsule);
}

}  // namespace detent
