// SPDX-License-Identifier: MIT
#pragma once

#include "detent/number/pi.hpp"
#include "detent/shape/aabb.hpp"
#include "detent/shape/obb.hpp"
#include "detent/shape/sphere.hpp"
#include "detent/shape/triangle.hpp"

// The size of shapes:
//   area(shape)    of triangles, and of boxes and discs in 2D
//   volume(shape)  of boxes and balls in 3D
//
// Each result has as many bits as it needs; `nearest_to<S>` rounds it to a scalar. An empty shape
// measures 0.

namespace detent {

namespace detail {

/// A number on the scalar's grid for the area of any triangle: half of |e| |f|, with edges of at
/// most sqrt(3) 2^(Bits + 1) raw units.
template <Scalar S>
struct area_of {
  using type = S;
};
template <int Bits, int Frac>
struct area_of<Fixed<Bits, Frac>> {
  using type = Fixed<result_bits(2 * Bits + 3 - Frac), Frac>;
};

/// Numbers on the scalar's grid for r^2 pi and for r^3 4 pi / 3, which is below 2^3 r^3.
template <Scalar S>
struct round_size_of {
  using area = S;
  using volume = S;
};
template <int Bits, int Frac>
struct round_size_of<Fixed<Bits, Frac>> {
  using area = Fixed<result_bits(2 * Bits + 2 - Frac), Frac>;
  using volume = Fixed<result_bits(3 * Bits + 3 - 2 * Frac), Frac>;
};

template <Number T>
[[nodiscard]] constexpr auto product(const Vec<T, 2>& v) noexcept {
  return v.x * v.y;
}
template <Number T>
[[nodiscard]] constexpr auto product(const Vec<T, 3>& v) noexcept {
  return v.x * v.y * v.z;
}

template <Scalar S, int N>
[[nodiscard]] constexpr auto size(const Aabb<S, N>& box) noexcept {
  const auto sides = box.max - box.min;
  return product(is_empty(box) ? decltype(sides)() : sides);
}

/// The sides of a box are twice its half extents; its axes are taken as orthonormal.
template <Scalar S, int N>
[[nodiscard]] constexpr auto size(const Obb<S, N>& box) noexcept {
  const auto sides = box.half_extents + box.half_extents;
  return product(is_empty(box) ? decltype(sides)() : sides);
}

}  // namespace detail

/// The area of a triangle, never negative.
///
/// exact: always                                           (tests/shape/measure.test.cpp)
template <Scalar S>
[[nodiscard]] constexpr auto area(const Triangle<S, 2>& triangle) noexcept {
  return half(abs(cross(triangle.b - triangle.a, triangle.c - triangle.a)));
}

/// The area of a triangle in space.
///
/// exact: rounded down to the grid of the scalar           (tests/shape/measure.test.cpp)
template <Scalar S>
[[nodiscard]] constexpr auto area(const Triangle<S, 3>& triangle) noexcept {
  const auto normal = cross(triangle.b - triangle.a, triangle.c - triangle.a);
  return sqrt_floor<typename detail::area_of<S>::type>(half(half(squared_length(normal))));
}

template <Scalar S>
[[nodiscard]] constexpr auto area(const Aabb<S, 2>& box) noexcept {
  return detail::size(box);
}
template <Scalar S>
[[nodiscard]] constexpr auto area(const Obb<S, 2>& box) noexcept {
  return detail::size(box);
}

/// The volume of a box, exactly; 0 for an empty one.
template <Scalar S>
[[nodiscard]] constexpr auto volume(const Aabb<S, 3>& box) noexcept {
  return detail::size(box);
}
template <Scalar S>
[[nodiscard]] constexpr auto volume(const Obb<S, 3>& box) noexcept {
  return detail::size(box);
}

/// The area of a disc, 0 for an empty one.
///
/// exact: within 0.5 + 2^-31 ULP                             (tests/shape/measure.test.cpp)
template <Scalar S>
[[nodiscard]] constexpr auto area(const Sphere<S, 2>& disc) noexcept {
  const S radius = disc.radius < 0 ? S(0) : disc.radius;
  return nearest_to<typename detail::round_size_of<S>::area>(times_pi(square(radius)));
}

/// The volume of a ball, 0 for an empty one.
///
/// exact: within 0.5 + 2^-31 ULP                             (tests/shape/measure.test.cpp)
template <Scalar S>
[[nodiscard]] constexpr auto volume(const Sphere<S, 3>& ball) noexcept {
  const S radius = ball.radius < 0 ? S(0) : ball.radius;
  return nearest_to<typename detail::round_size_of<S>::volume>(
      times_four_thirds_pi(square(radius) * radius));
}

}  // namespace detent
