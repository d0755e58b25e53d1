// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/beyond.hpp"
#include "detent/query/kernel/point_hull.hpp"

namespace detent::detail {

/// Whether `point` is in `frustum`.
template <Scalar S>
[[nodiscard]] constexpr bool holds(const Frustum<S>& frustum, const Vec<S, 3>& point) noexcept {
  return !is_beyond(frustum, point) && holds(frustum.hull(), point);
}

/// Whether `point` is within `reach` >= 0 of `frustum`.
template <Scalar S>
[[nodiscard]] constexpr bool within_reach(const Frustum<S>& frustum, const Vec<S, 3>& point,
                                          const S& reach) noexcept {
  return within_reach(frustum.hull(), point, reach);
}

}  // namespace detent::detail
