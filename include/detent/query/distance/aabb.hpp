// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/point_aabb.hpp"

namespace detent {

/// The squared distance from `point` to `box`, 0 inside.
///
/// domain: every input; an empty box gives the greatest number of the result's type
/// exact:  always                                               (tests/oracle/point_aabb.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr auto squared_distance(const Aabb<S, N>& box,
                                              const Vec<S, N>& point) noexcept {
  using Squared = decltype(squared_distance(point, point));
  if (is_empty(box)) return largest<Squared>;
  return squared_distance(point, detail::clamp_to(box, point));
}

/// The distance from `point` to `box`, 0 inside.
///
/// units:  world units
/// domain: every input; clamped to the greatest scalar, which is the result for an empty box
/// exact:  rounded down, error in [0, 1) ULP                    (tests/oracle/point_aabb.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr S distance(const Aabb<S, N>& box, const Vec<S, N>& point) noexcept {
  if (is_empty(box)) return largest<S>;
  return distance(point, detail::clamp_to(box, point));
}

}  // namespace detent
