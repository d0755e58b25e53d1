// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/point_hull.hpp"

namespace detent {

/// The squared distance from `point` to `hull`, 0 inside: |w|^2 from a corner, |w x e|^2 / |e|^2
/// from an edge, (n . w)^2 / |n|^2 from a face with normal n.
///
/// domain: every input; an empty hull gives the greatest number of the result's type
/// exact:  the fraction is the exact value                      (tests/oracle/point_hull.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr auto squared_distance(const ConvexHull<S, N>& hull,
                                              const Vec<S, N>& point) noexcept {
  using Result = decltype(detail::squared_distance_from_hull(hull, point));
  if (!is_empty(hull)) return detail::squared_distance_from_hull(hull, point);
  using Under = decltype(Result::denominator);
  return Result{largest<decltype(Result::numerator)>, Under(1)};
}

/// The distance from `point` to `hull`, 0 inside.
///
/// units:  world units
/// domain: every input; clamped to the greatest scalar, which is the result for an empty hull
/// exact:  rounded down, error in [0, 1) ULP                    (tests/oracle/point_hull.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr S distance(const ConvexHull<S, N>& hull, const Vec<S, N>& point) noexcept {
  if (is_empty(hull)) return largest<S>;
  return sqrt_floor<S>(squared_distance(hull, point));
}

}  // namespace detent
