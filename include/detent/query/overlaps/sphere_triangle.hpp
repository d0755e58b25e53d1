// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/within_triangle.hpp"
#include "detent/shape/sphere.hpp"

namespace detent {

/// Whether `sphere` and `triangle` share a point.
///
/// domain: every input; a negative radius is an empty sphere and overlaps nothing; a collapsed
///         triangle is the segment or point that its corners span
/// exact:  yes or no exact; touching counts                  (tests/oracle/sphere_edges.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Sphere<S, N>& sphere,
                                      const Triangle<S, N>& triangle) noexcept {
  return sphere.radius >= 0 && detail::within_reach(triangle, sphere.center, sphere.radius);
}
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Triangle<S, N>& triangle,
                                      const Sphere<S, N>& sphere) noexcept {
  return overlaps(sphere, triangle);
}

}  // namespace detent
