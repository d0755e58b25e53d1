// SPDX-License-Identifier: MIT
#pragma once

#include "detent/math/components.hpp"
#include "detent/shape/plane.hpp"

namespace detent {

/// Whether two planes (lines in 2D) share a point, with the normals exactly as stored.
///
/// domain: every input; normals that differ only in the last place are not parallel
/// exact:  yes or no exact                                     (tests/oracle/plane_plane.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Plane<S, N>& a, const Plane<S, N>& b) noexcept {
  if (!detail::are_parallel(a.normal, b.normal.vec())) return true;
  // Parallel normals may have opposite signs and differ in length: the planes are the same if their
  // equations are proportional.
  for (int i = 0; i < N; ++i) {
    if (a.normal[i] * b.offset != b.normal[i] * a.offset) return false;
  }
  return true;
}

}  // namespace detent
