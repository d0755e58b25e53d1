// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/point_aabb.hpp"

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
  return is_empty(box) ? point : detail::clamp_to(box, point);
}

}  // namespace detent
