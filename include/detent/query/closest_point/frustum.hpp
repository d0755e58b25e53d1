// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/closest_point/hull.hpp"
#include "detent/shape/frustum.hpp"

namespace detent {

/// The point of `frustum` closest to `point`; `point` itself if inside.
///
/// exact: as for the hull of the corners                            (tests/oracle/frustum.test.cpp)
template <Scalar S>
[[nodiscard]] constexpr Vec<S, 3> closest_point(const Frustum<S>& frustum,
                                                const Vec<S, 3>& point) noexcept {
  return closest_point(frustum.hull(), point);
}

}  // namespace detent
