// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/point_capsule.hpp"

namespace detent {

/// Whether `point` is in `capsule`, surface included.
///
/// domain: every input; a negative radius is an empty capsule and contains nothing
/// exact:  yes or no exact                                   (tests/oracle/point_capsule.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool contains(const Capsule<S, N>& capsule,
                                      const Vec<S, N>& point) noexcept {
  return detail::holds(capsule, point);
}

}  // namespace detent
