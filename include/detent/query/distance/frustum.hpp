// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/distance/hull.hpp"
#include "detent/shape/frustum.hpp"

namespace detent {

/// The squared distance from `point` to `frustum`, 0 inside.
///
/// exact: as for the hull of the corners                            (tests/oracle/frustum.test.cpp)
template <Scalar S>
[[nodiscard]] constexpr auto squared_distance(const Frustum<S>& frustum,
                                              const Vec<S, 3>& point) noexcept {
  return squared_distance(frustum.hull(), point);
}

/// The distance from `point` to `frustum`, 0 inside.
///
/// exact: as for the hull of the corners                            (tests/oracle/frustum.test.cpp)
template <Scalar S>
[[nodiscard]] constexpr S distance(const Frustum<S>& frustum, const Vec<S, 3>& point) noexcept {
  return distance(frustum.hull(), point);
}

}  // namespace detent
