// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/point_plane.hpp"

namespace detent {

/// Whether `point` lies in `plane`: dot(normal, point) = offset, with the normal exactly as stored.
///
/// domain: every input
/// exact:  yes or no exact                                     (tests/oracle/point_plane.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool contains(const Plane<S, N>& plane, const Vec<S, N>& point) noexcept {
  return detail::holds(plane, point);
}

}  // namespace detent
