// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "detent/shape/plane.hpp"
#include "detent/shape/triangle.hpp"

namespace detent {

/// Whether `triangle` has a point in `plane`, with the normal exactly as stored.
///
/// domain: every input; a collapsed triangle is the segment or point that its corners span
/// exact:  yes or no exact                                  (tests/oracle/plane_triangle.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Plane<S, N>& plane,
                                      const Triangle<S, N>& triangle) noexcept {
  const auto a = dot(plane.normal, triangle.a);
  const auto b = dot(plane.normal, triangle.b);
  const auto c = dot(plane.normal, triangle.c);
  return (std::min)({a, b, c}) <= plane.offset && plane.offset <= (std::max)({a, b, c});
}

template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Triangle<S, N>& triangle,
                                      const Plane<S, N>& plane) noexcept {
  return overlaps(plane, triangle);
}

}  // namespace detent
