// SPDX-License-Identifier: MIT
#pragma once

#include "detent/shape/moved.hpp"

namespace detent::detail {

template <Scalar S, int N>
[[nodiscard]] constexpr bool only_moves(const Transform<S, N>& transform) noexcept {
  return transform.scale == 1 && transform.rotation == Rotation<S, N>();
}

/// placed(transform, shape), with less work if the transform only translates.
template <Scalar S, int N, class Shape>
[[nodiscard]] constexpr Shape put(const Transform<S, N>& transform, const Shape& shape) noexcept {
  return only_moves(transform) ? translated(shape, transform.translation)
                               : placed(transform, shape);
}

template <Scalar S, Number T>
[[nodiscard]] constexpr bool is_in_range(const Vec<T, 3>& v) noexcept {
  const auto rounded = nearest_to<S>(v);
  return rounded.x == v.x && rounded.y == v.y && rounded.z == v.z;
}

}  // namespace detent::detail
