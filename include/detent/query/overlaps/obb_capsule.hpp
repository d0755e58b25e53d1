// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/point_obb.hpp"
#include "detent/query/kernel/within_slabs.hpp"
#include "detent/shape/capsule.hpp"

namespace detent {

/// Whether `box` and `capsule` share a point.
///
/// The box is its slabs, {x : |dot(axis(i), x - center)| <= half_extents[i]}, with the axes exactly
/// as stored. The capsule's radius is measured in their frame: see `squared_distance`.
///
/// domain: every input; an empty box or capsule overlaps nothing
/// exact:  yes or no exact; touching counts                 (tests/oracle/capsule_boxes.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Obb<S, N>& box, const Capsule<S, N>& capsule) noexcept {
  const auto& a = capsule.a;
  const auto& b = capsule.b;
  const auto& radius = capsule.radius;  // older compilers do not capture structured bindings
  if (is_empty(box) || radius < 0) return false;
  const auto& half = box.half_extents;
  const auto center = detail::in_frame(box, box.center - a), along = detail::in_frame(box, b - a);
  const auto low = center - half, high = center + half;
  if constexpr (is_fixed<S>) {
    using Place = decltype(low.x);
    return or_exact(detail::decide_within_slabs(low, high, along, Place(radius)),
                    [&] { return detail::within_slabs(low, high, along, radius); });
  } else {
    return detail::within_slabs(low, high, along, radius);
  }
}
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Capsule<S, N>& capsule, const Obb<S, N>& box) noexcept {
  return overlaps(box, capsule);
}

}  // namespace detent
