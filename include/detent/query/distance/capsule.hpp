// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/length.hpp"
#include "detent/query/kernel/point_capsule.hpp"
#include "detent/query/kernel/point_segment.hpp"

namespace detent {

/// The distance from `point` to `capsule`, 0 inside.
///
/// units:  world units
/// domain: every input; clamped to the greatest scalar, which is the result for an empty capsule
/// exact:  rounded down, error in [0, 1) ULP                 (tests/oracle/point_capsule.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr S distance(const Capsule<S, N>& capsule, const Vec<S, N>& point) noexcept {
  if (capsule.radius < 0) return largest<S>;
  if constexpr (!is_fixed<S>) {
    if (detail::holds(capsule, point)) return S(0);
  }
  const Segment axis{capsule.a, capsule.b};
  return detail::less_radius<S>(detail::distance_to<detail::Length<S>>(axis, point),
                                capsule.radius);
}

}  // namespace detent
