// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/contains/hull.hpp"
#include "detent/query/kernel/beyond.hpp"

namespace detent {

/// Whether `point` is in `frustum`, its faces, edges and corners included.
///
/// domain: every input
/// exact:  yes or no exact, for the hull of the corners             (tests/oracle/frustum.test.cpp)
template <Scalar S>
[[nodiscard]] constexpr bool contains(const Frustum<S>& frustum, const Vec<S, 3>& point) noexcept {
  return !detail::is_beyond(frustum, point) && contains(frustum.hull(), point);
}

}  // namespace detent
