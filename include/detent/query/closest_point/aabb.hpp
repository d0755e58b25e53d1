// SPDX-License-Identifier: MIT
#pragma once

#include "detent/shape/aabb.hpp"

namespace detent {

/// The point of `box` closest to `point`; `point` itself if inside.
///
/// units:  world units
/// domain: every input; an empty box gives `point`
/// exact:  always                                               (tests/oracle/point_aabb.test.cpp)
/// source: Ericson, Real-Time Collision Detection, 5.1.3
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<S, N> closest_point(const Aabb<S, N>& box,
                                                const Vec<S, N>& point) noexcept {
  if (is_empty(box)) return point;
  return make_vec<N>([&](int i) {
    // On copies, which clang selects without a branch.
    const S x = point[i], low = box.min[i], high = box.max[i];
    const S raised = x < low ? low : x;
    return raised > high ? high : raised;
  });
}

}  // namespace detent
