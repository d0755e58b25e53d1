// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/contains/segment.hpp"
#include "detent/shape/triangle.hpp"

namespace detent {

/// Whether `point` is in the 2D `triangle`, edges included.
///
/// domain: every input; a collapsed triangle is the segment or point that its corners span
/// exact:  yes or no exact                                  (tests/oracle/point_triangle.test.cpp)
template <Scalar S>
[[nodiscard]] constexpr bool contains(const Triangle<S, 2>& triangle,
                                      const Vec<S, 2>& point) noexcept {
  const auto& [a, b, c] = triangle;
  if (cross(b - a, c - a) == 0) return contains(detail::collapsed(triangle), point);
  const auto ab = cross(b - a, point - a);
  const auto bc = cross(c - b, point - b);
  const auto ca = cross(a - c, point - c);
  return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
}

/// Whether `point` lies on the 3D `triangle`, edges included.
///
/// domain: every input; a collapsed triangle is the segment or point that its corners span
/// exact:  yes or no exact                                  (tests/oracle/point_triangle.test.cpp)
template <Scalar S>
[[nodiscard]] constexpr bool contains(const Triangle<S, 3>& triangle,
                                      const Vec<S, 3>& point) noexcept {
  const auto& [a, b, c] = triangle;
  const auto normal = cross(b - a, c - a);
  if (detail::is_zero(normal)) return contains(detail::collapsed(triangle), point);
  if (dot(normal, point - a) != 0) return false;
  // In the triangle's plane the other two coordinates decide: drop the normal's longest axis.
  const int axis = detail::longest_axis(normal);
  return contains(
      Triangle{detail::without(a, axis), detail::without(b, axis), detail::without(c, axis)},
      detail::without(point, axis));
}

}  // namespace detent
