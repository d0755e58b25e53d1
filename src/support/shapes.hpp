// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

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
template <Scalar S, int N>
constexpr std::string_view name_of(const Sphere<S, N>&) {
  return "sphere";
}
template <Scalar S, int N, class F>
constexpr auto mapped(const Aabb<S, N>& box, F&& f) {
  return Aabb{f(box.min), f(box.max)};
}
template <Scalar S, int N>
constexpr std::string_view name_of(const Aabb<S, N>&) {
  return "aabb";
}
template <Scalar S, int N, class F>
constexpr auto mapped(const Obb<S, N>& box, F&& f) {
  return Obb{f(box.center), f(box.half_extents), f(box.rotation)};
}
template <Scalar S, int N>
constexpr std::string_view name_of(const Obb<S, N>&) {
  return "obb";
}
template <Scalar S, int N, class F>
constexpr auto mapped(const Plane<S, N>& plane, F&& f) {
  return Plane{f(plane.normal), f(plane.offset)};
}
template <Scalar S, int N>
constexpr std::string_view name_of(const Plane<S, N>&) {
  return "plane";
}
template <Scalar S, int N, class F>
constexpr auto mapped(const Triangle<S, N>& triangle, F&& f) {
  const auto a = f(triangle.a), b = f(triangle.b), c = f(triangle.c);
  const auto make = []<Scalar T, int M>(const Vec<T, M>& p, const Vec<T, M>& q,
                                        const Vec<T, M>& r) {
    return Triangle<T, M>{p, q, r};
  };
  return make(a, b, c);
}
template <Scalar S, int N>
constexpr std::string_view name_of(const Triangle<S, N>&) {
  return "triangle";
}
template <Scalar S, int N, class F>
constexpr auto mapped(const Capsule<S, N>& capsule, F&& f) {
  return Capsule{f(capsule.a), f(capsule.b), f(capsule.radius)};
}
template <Scalar S, int N>
constexpr std::string_view name_of(const Capsule<S, N>&) {
  return "capsule";
}
template <Scalar S, int N, class F>
constexpr auto mapped(const Segment<S, N>& segment, F&& f) {
  return Segment{f(segment.start), f(segment.end)};
}
template <Scalar S, int N>
constexpr std::string_view name_of(const Segment<S, N>&) {
  return "segment";
}
template <Scalar S, int N, class F>
constexpr auto mapped(const Ray<S, N>& ray, F&& f) {
  return Ray{f(ray.origin), f(ray.direction), f(ray.max_distance)};
}
template <Scalar S, int N>
constexpr std::string_view name_of(const Ray<S, N>&) {
  return "ray";
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
