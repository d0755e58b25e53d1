// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <type_traits>

#include "detent/query/cast/motion.hpp"

namespace detent::detail {

/// Whether a shape that moves along `direction` by `distance` stays on one side of the plane of a
/// triangle, so that they never touch. Exact; false if the triangle collapses.
template <class Shape, Scalar S>
[[nodiscard]] constexpr bool stays_beside(const Shape& shape, const Direction<S, 3>& direction,
                                          const S& distance,
                                          const Triangle<S, 3>& triangle) noexcept {
  const auto body = body_of(core_of(shape));
  const auto normal = cross(triangle.b - triangle.a, triangle.c - triangle.a);
  constexpr int bits = bits_of<std::remove_cvref_t<decltype(body.some().x)>> + 1;
  const auto height = [&](bool farthest) {
    return dot(normal, body.template extreme<bits>(normal, body.some(), farthest)) -
           dot(normal, triangle.a);
  };
  const auto rise = dot(normal, direction) * distance;
  using Gap = std::remove_cvref_t<decltype(height(true) + rise)>;
  const Gap lowest(height(false)), highest(height(true));
  const Gap above = rise < 0 ? Gap(narrow<bits_of<Gap>>(lowest + rise)) : lowest;
  const Gap below = rise < 0 ? highest : Gap(narrow<bits_of<Gap>>(highest + rise));
  if (above > 0) return square(above) > square(radius_of(shape)) * squared_length(normal);
  if (below < 0) return square(below) > square(radius_of(shape)) * squared_length(normal);
  return false;
}

}  // namespace detent::detail
