// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/point_hull.hpp"

namespace detent {

/// Whether `point` is in `hull`, its faces, edges and corners included.
///
/// domain: every input; a flat hull is the polygon, segment or point that its points span; one
///         without points is empty
/// exact:  yes or no exact                                      (tests/oracle/point_hull.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool contains(const ConvexHull<S, N>& hull,
                                      const Vec<S, N>& point) noexcept {
  return detail::holds(hull, point);
}

}  // namespace detent
