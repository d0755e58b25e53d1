// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/point_frustum.hpp"

namespace detent {

/// Whether `point` is in `frustum`, its faces, edges and corners included.
///
/// domain: every input
/// exact:  yes or no exact, for the hull of the corners             (tests/oracle/frustum.test.cpp)
template <Scalar S>
[[nodiscard]] constexpr bool contains(const Frustum<S>& frustum, const Vec<S, 3>& point) noexcept {
  return detail::holds(frustum, point);
}

}  // namespace detent
