// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/argument.hpp"
#include "detent/shape/frustum.hpp"

// A shape is the set of points within its radius of its core: the core of a round shape, otherwise
// the shape itself.

namespace detent::detail {

template <class T, template <class, int> class Shape>
inline constexpr bool is_kind = false;
template <template <class, int> class Shape, class S, int N>
inline constexpr bool is_kind<Shape<S, N>, Shape> = true;

template <class Shape>
[[nodiscard]] constexpr const Shape& core_of(const Shape& shape) noexcept {
  return shape;
}
template <Round Shape>
[[nodiscard]] constexpr decltype(auto) core_of(const Shape& shape) noexcept {
  return ShapeFields<Shape>::core(shape);
}
template <Scalar S>
[[nodiscard]] constexpr ConvexHull<S, 3> core_of(const Frustum<S>& frustum) noexcept {
  return frustum.hull();
}

template <class Shape>
[[nodiscard]] constexpr auto radius_of(const Shape& shape) noexcept {
  if constexpr (requires { shape.radius; }) {
    return shape.radius;
  } else {
    return decltype(PointOf<Shape>::type::x)(0);
  }
}

template <class Shape>
[[nodiscard]] constexpr bool has_points(const Shape& shape) noexcept {
  if constexpr (requires { is_empty(shape); }) {
    return !is_empty(shape);
  } else {
    return !(radius_of(shape) < 0);
  }
}

}  // namespace detent::detail
