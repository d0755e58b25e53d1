// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/within_slabs.hpp"
#include "detent/shape/aabb.hpp"
#include "detent/shape/capsule.hpp"

namespace detent {

/// Whether `box` and `capsule` share a point.
///
/// domain: every input; an empty box or capsule overlaps nothing
/// exact:  yes or no exact; touching counts                 (tests/oracle/capsule_boxes.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Aabb<S, N>& box,
                                      const Capsule<S, N>& capsule) noexcept {
  const auto& [a, b, radius] = capsule;
  if (is_empty(box) || radius < 0) return false;
  return by_width<30>([](const auto&... x) { return detail::within_slabs(x...); }, box.min - a,
                      box.max - a, b - a, radius);
}
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Capsule<S, N>& capsule,
                                      const Aabb<S, N>& box) noexcept {
  return overlaps(box, capsule);
}

}  // namespace detent
