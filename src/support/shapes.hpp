// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "detent/math/rotation.hpp"
#include "detent/shape/shape.hpp"

// Every shape as its fields, for `verify`, the accuracy study, properties and benchmarks, which
// convert shapes between scalars and dimensions: a new shape has one function here.
namespace detent::support {

/// The shape made of `f(field)` for each field: a number, a point, a direction or a rotation.
template <Scalar S, int N, class F>
constexpr auto mapped(const Sphere<S, N>& sphere, F&& f) {
  return Sphere{f(sphere.center), f(sphere.radius)};
}
template <Scalar S, int N, class F>
constexpr auto mapped(const Aabb<S, N>& box, F&& f) {
  return Aabb{f(box.min), f(box.max)};
}
template <Scalar S, int N, class F>
constexpr auto mapped(const Obb<S, N>& box, F&& f) {
  return Obb{f(box.center), f(box.half_extents), f(box.rotation)};
}
template <Scalar S, int N, class F>
constexpr auto mapped(const Plane<S, N>& plane, F&& f) {
  return Plane{f(plane.normal), f(plane.offset)};
}
template <Scalar S, int N, class F>
constexpr auto mapped(const Triangle<S, N>& triangle, F&& f) {
  const auto make = []<Scalar T, int M>(const Vec<T, M>& a, const Vec<T, M>& b,
                                        const Vec<T, M>& c) {
    return Triangle<T, M>{a, b, c};
  };
  return make(f(triangle.a), f(triangle.b), f(triangle.c));
}
template <Scalar S, int N, class F>
constexpr auto mapped(const Capsule<S, N>& capsule, F&& f) {
  return Capsule{f(capsule.a), f(capsule.b), f(capsule.radius)};
}
template <Scalar S, int N, class F>
constexpr auto mapped(const Segment<S, N>& segment, F&& f) {
  return Segment{f(segment.start), f(segment.end)};
}
template <Scalar S, int N, class F>
constexpr auto mapped(const Ray<S, N>& ray, F&& f) {
  return Ray{f(ray.origin), f(ray.direction), f(ray.max_distance)};
}

template <class Shape>
concept Mappable = requires(const Shape& shape) {
  mapped(shape, [](const auto& field) { return field; });
};

/// The rotation with the axes `f(axis)`, in a scalar T.
template <Scalar T, Scalar S, int N, class F>
constexpr Rotation<T, N> mapped_axes(const Rotation<S, N>& rotation, F&& f) {
  std::array<Direction<T, N>, static_cast<std::size_t>(N)> axes;
  for (int i = 0; i < N; ++i) axes[static_cast<std::size_t>(i)] = f(rotation.axis(i));
  return Rotation<T, N>::from_axes(axes);
}

}  // namespace detent::support
