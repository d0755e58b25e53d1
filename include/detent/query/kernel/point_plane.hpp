// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "detent/number/fraction.hpp"
#include "detent/shape/plane.hpp"

namespace detent::detail {

/// dot(normal, point) - offset: the distance to the plane times the length of the normal, positive
/// on the side that the normal points to.
template <Scalar S, int N>
[[nodiscard]] constexpr auto height_above(const Plane<S, N>& plane,
                                          const Vec<S, N>& point) noexcept {
  // sqrt(3) 2^B (1 + 2^-13) + 2^B < 2^(B + 2), in units where a direction's component 1 is 2^0.
  constexpr int bits = bits_of<S> + bits_of<direction_component<S>> + 1;
  return narrow_difference<bits>(dot(plane.normal, point), plane.offset);
}

/// The same for a point on a finer grid.
template <Scalar S, Number T, int N>
[[nodiscard]] constexpr auto height_above(const Plane<S, N>& plane,
                                          const Vec<T, N>& point) noexcept {
  return dot(plane.normal, point) - plane.offset;
}

/// The heights of the lowest and of the highest corner of a body.
template <Scalar S, int N, class Body>
[[nodiscard]] constexpr auto heights_above(const Plane<S, N>& plane, const Body& body) noexcept {
  constexpr int bits = bits_of<decltype(body.some().x)> + 1;
  const auto height = [&](bool farthest) {
    return height_above(plane,
                        body.template extreme<bits>(plane.normal.vec(), body.some(), farthest));
  };
  return std::pair{height(false), height(true)};
}

/// Whether `point` lies in `plane`: dot(normal, point) = offset, with the normal exactly as stored.
template <Scalar S, int N>
[[nodiscard]] constexpr bool holds(const Plane<S, N>& plane, const Vec<S, N>& point) noexcept {
  return dot(plane.normal, point) == plane.offset;
}

/// Whether `point` is within `reach` >= 0 of `plane`: height^2 <= reach^2 n^2, with the normal n
/// exactly as stored.
template <Scalar S, int N>
[[nodiscard]] constexpr bool within_reach(const Plane<S, N>& plane, const Vec<S, N>& point,
                                          const S& reach) noexcept {
  const auto height = height_above(plane, point);
  return Fraction{height * height, squared_length(plane.normal)} <= square(reach);
}

}  // namespace detent::detail
