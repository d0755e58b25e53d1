// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/within_segment.hpp"
#include "detent/shape/capsule.hpp"

namespace detent::detail {

/// Whether `point` is in `capsule`.
template <Scalar S, int N>
[[nodiscard]] constexpr bool holds(const Capsule<S, N>& capsule, const Vec<S, N>& point) noexcept {
  return capsule.radius >= 0 && within_reach(Segment{capsule.a, capsule.b}, point, capsule.radius);
}

/// Whether `point` is within `reach` >= 0 of `capsule`.
template <Scalar S, int N>
[[nodiscard]] constexpr bool within_reach(const Capsule<S, N>& capsule, const Vec<S, N>& point,
                                          const S& reach) noexcept {
  return capsule.radius >= 0 &&
         within_reach(Segment{capsule.a, capsule.b}, point, capsule.radius + reach);
}

}  // namespace detent::detail
