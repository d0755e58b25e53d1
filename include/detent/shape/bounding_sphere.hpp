// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "detent/shape/bounding_box.hpp"

// A sphere around points or a shape:
//   bounding_sphere(shape) -> Sphere<S, N>
//
// The center is the middle of the bounding box, or the shape's own. The radius is the smallest on
// the grid that reaches every point from there. For points it is at most sqrt(N) times that of the
// smallest sphere, because no side of the bounding box exceeds that sphere's diameter. Radii are
// clamped to the greatest scalar, so only a sphere that needs a greater radius leaves points out.
// An empty shape has an empty sphere.

namespace detent {

namespace detail {

template <Scalar S, int N>
[[nodiscard]] constexpr Vec<S, N> middle(const Aabb<S, N>& box) noexcept {
  return make_vec<N>([&](int i) { return nearest_to<S>(half(box.min[i] + box.max[i])); });
}

template <class Sphere>
inline constexpr Sphere no_sphere;
template <Scalar S, int N>
inline constexpr Sphere<S, N> no_sphere<Sphere<S, N>> = {{}, S(-1)};

}  // namespace detail

/// A sphere around points, empty if there are none.
///
/// exact: the center rounded to nearest, then the radius rounded up
///        (tests/shape/bounding.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr Sphere<S, N> bounding_sphere(std::span<const Vec<S, N>> points) noexcept {
  if (points.empty()) return detail::no_sphere<Sphere<S, N>>;
  const auto center = detail::middle(bounding_box(points));
  auto farthest = squared_distance(points.front(), center);
  for (const auto& point : points) {
    farthest = (std::max)(farthest, squared_distance(point, center));
  }
  return {center, sqrt_ceil<S>(farthest)};
}

template <Scalar S, int N>
[[nodiscard]] constexpr Sphere<S, N> bounding_sphere(const ConvexHull<S, N>& hull) noexcept {
  return bounding_sphere(hull.points);
}

template <Scalar S, int N>
[[nodiscard]] constexpr Sphere<S, N> bounding_sphere(const Segment<S, N>& segment) noexcept {
  return bounding_sphere<S, N>(std::array{segment.start, segment.end});
}

template <Scalar S, int N>
[[nodiscard]] constexpr Sphere<S, N> bounding_sphere(const Triangle<S, N>& triangle) noexcept {
  return bounding_sphere<S, N>(std::array{triangle.a, triangle.b, triangle.c});
}

template <Scalar S, int N>
[[nodiscard]] constexpr Sphere<S, N> bounding_sphere(const Sphere<S, N>& sphere) noexcept {
  return sphere;
}

/// The sphere around the core of a round shape, grown by the shape's radius.
template <detail::Round Shape>
[[nodiscard]] constexpr auto bounding_sphere(const Shape& shape) noexcept {
  auto sphere = bounding_sphere(detail::ShapeFields<Shape>::core(shape));
  if (shape.radius < 0) return detail::no_sphere<decltype(sphere)>;
  sphere.radius = floor_to<decltype(sphere.radius)>(sphere.radius + shape.radius);
  return sphere;
}

template <Scalar S, int N>
[[nodiscard]] constexpr Sphere<S, N> bounding_sphere(const Aabb<S, N>& box) noexcept {
  if (is_empty(box)) return detail::no_sphere<Sphere<S, N>>;
  const auto center = detail::middle(box);
  // The corner that is farthest on every axis.
  return {center, sqrt_ceil<S>(squared_length(make_vec<N>([&](int i) {
            return (std::max)(box.max[i] - center[i], center[i] - box.min[i]);
          })))};
}

/// A sphere about the center of an `Obb` and around its edges, with its axes exactly as stored.
///
/// exact: the radius rounded up                            (tests/shape/bounding.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr Sphere<S, N> bounding_sphere(const Obb<S, N>& box) noexcept {
  if (is_empty(box)) return detail::no_sphere<Sphere<S, N>>;
  // On the grid of h, a corner is less than N h (1 + 2^-13) < 2^(2 + bits) from the center, and so
  // is every partial sum.
  constexpr int corner_bits = bits_of<S> + bits_of<direction_component<S>> + 1;
  const auto corner = [&](int signs) {
    return make_vec<N>([&](int j) {
      const auto row = make_vec<N>([&](int i) {
        const auto along = box.rotation.axis(i)[j];
        return (signs >> i & 1) != 0 ? narrow_negative(along) : along;
      });
      return narrow_dot<corner_bits>(row, box.half_extents);
    });
  };
  auto farthest = squared_length(corner(0));
  for (int signs = 1; signs < 1 << (N - 1); ++signs) {  // the others are opposite corners
    farthest = (std::max)(farthest, squared_length(corner(signs)));
  }
  return {box.center, sqrt_ceil<S>(farthest)};
}

/// A sphere around the spheres of all parts of a compound.
template <class Shape, class... Shapes>
[[nodiscard]] constexpr auto bounding_sphere(const Compound<Shape, Shapes...>& compound) noexcept {
  using Result = decltype(bounding_sphere(Shape()));
  const auto box = bounding_box(compound);
  if (is_empty(box)) return detail::no_sphere<Result>;
  Result whole{detail::middle(box), {}};
  for_each_part(compound, [&](const auto& part) {
    const auto around = bounding_sphere(part);
    if (around.radius < 0) return;
    using S = decltype(around.radius);
    const auto to_center = sqrt_ceil<S>(squared_distance(around.center, whole.center));
    whole.radius = (std::max)(whole.radius, floor_to<S>(to_center + around.radius));
  });
  return whole;
}

}  // namespace detent
