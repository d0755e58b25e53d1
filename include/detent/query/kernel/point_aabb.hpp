// SPDX-License-Identifier: MIT
#pragma once

#include "detent/shape/aabb.hpp"

namespace detent::detail {

/// The point of `box`, which must not be empty, closest to `point`: each coordinate clamped to the
/// box.
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<S, N> clamp_to(const Aabb<S, N>& box, const Vec<S, N>& point) noexcept {
  return make_vec<N>([&](int i) {
    // On copies, which clang selects without a branch.
    const S x = point[i], low = box.min[i], high = box.max[i];
    const S raised = x < low ? low : x;
    return raised > high ? high : raised;
  });
}

/// Whether `point` is within `reach` >= 0 of `box`.
template <Scalar S, int N>
[[nodiscard]] constexpr bool within_reach(const Aabb<S, N>& box, const Vec<S, N>& point,
                                          const S& reach) noexcept {
  return !is_empty(box) && squared_distance(point, clamp_to(box, point)) <= square(reach);
}

}  // namespace detent::detail
