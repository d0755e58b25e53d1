// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/point_triangle.hpp"

namespace detent {

/// Whether `point` is in `triangle`, edges included: a solid in 2D, a surface in 3D.
///
/// domain: every input; a collapsed triangle is the segment or point that its corners span
/// exact:  yes or no exact                                  (tests/oracle/point_triangle.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool contains(const Triangle<S, N>& triangle,
                                      const Vec<S, N>& point) noexcept {
  return detail::holds(triangle, point);
}

}  // namespace detent
