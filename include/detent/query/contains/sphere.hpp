// SPDX-License-Identifier: MIT
#pragma once

#include "detent/shape/sphere.hpp"

namespace detent {

/// Whether `point` is in `sphere`, surface included.
///
/// domain: every input; a negative radius is an empty sphere and contains nothing
/// exact:  yes or no exact                                    (tests/oracle/point_sphere.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool contains(const Sphere<S, N>& sphere, const Vec<S, N>& point) noexcept {
  return sphere.radius >= 0 && squared_distance(point, sphere.center) <= square(sphere.radius);
}

}  // namespace detent
