// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/point_sphere.hpp"

namespace detent {

/// Whether two spheres share a point.
///
/// domain: every input; a negative radius is an empty sphere and overlaps nothing
/// exact:  yes or no exact; touching counts                  (tests/oracle/sphere_pairs.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Sphere<S, N>& a, const Sphere<S, N>& b) noexcept {
  return b.radius >= 0 && detail::within_reach(a, b.center, b.radius);
}

}  // namespace detent
