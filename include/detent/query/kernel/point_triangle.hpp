// SPDX-License-Identifier: MIT
#pragma once

#include "detent/math/components.hpp"
#include "detent/number/filter/residue.hpp"
#include "detent/query/kernel/collapsed.hpp"
#include "detent/query/kernel/point_segment.hpp"
#include "detent/shape/triangle.hpp"

namespace detent::detail {

/// Whether `point` is in the 2D `triangle`, edges included.
template <Scalar S>
[[nodiscard]] constexpr bool holds(const Triangle<S, 2>& triangle,
                                   const Vec<S, 2>& point) noexcept {
  const auto& [a, b, c] = triangle;
  if (cross(b - a, c - a) == 0) return holds(collapsed(triangle), point);
  const auto ab = cross(b - a, point - a);
  const auto bc = cross(c - b, point - b);
  const auto ca = cross(a - c, point - c);
  return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
}

/// Whether `point` lies on the 3D `triangle`, edges included.
template <Scalar S>
[[nodiscard]] constexpr bool holds(const Triangle<S, 3>& triangle,
                                   const Vec<S, 3>& point) noexcept {
  const auto& [a, b, c] = triangle;
  if constexpr (is_fixed<S> && has_long_registers) {
    // A point off the plane, as nearly all are.
    const auto volume = is_zero_volume(to_array(point - a), to_array(b - a), to_array(c - a));
    if (volume == Filtered::no) return false;
  }
  const auto normal = cross(b - a, c - a);
  if (is_zero(normal)) return holds(collapsed(triangle), point);
  if (dot(normal, point - a) != 0) return false;
  // In the triangle's plane the other two coordinates decide: drop the normal's longest axis.
  const int axis = longest_axis(normal);
  return holds(Triangle{without(a, axis), without(b, axis), without(c, axis)},
               without(point, axis));
}

}  // namespace detent::detail
