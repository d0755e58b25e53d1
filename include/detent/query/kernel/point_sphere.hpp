// SPDX-License-Identifier: MIT
#pragma once

#include "detent/shape/sphere.hpp"

namespace detent::detail {

/// Whether `point` is within `reach` >= 0 of `sphere`.
template <Scalar S, int N>
[[nodiscard]] constexpr bool within_reach(const Sphere<S, N>& sphere, const Vec<S, N>& point,
                                          const S& reach) noexcept {
  return sphere.radius >= 0 &&
         squared_distance(point, sphere.center) <= square(sphere.radius + reach);
}

}  // namespace detent::detail
