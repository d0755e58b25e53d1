// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/overlaps/hull_hull.hpp"
#include "detent/shape/triangle.hpp"

namespace detent {

/// Whether `triangle` and `hull` share a point.
///
/// domain: every input; a collapsed triangle is the segment or point that its corners span; an
///         empty hull overlaps nothing
/// exact:  yes or no exact; touching counts                    (tests/oracle/hull_pairs.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Triangle<S, N>& triangle,
                                      const ConvexHull<S, N>& hull) noexcept {
  const std::array corners{triangle.a, triangle.b, triangle.c};
  return overlaps(ConvexHull{corners}, hull);
}
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const ConvexHull<S, N>& hull,
                                      const Triangle<S, N>& triangle) noexcept {
  return overlaps(triangle, hull);
}

}  // namespace detent
