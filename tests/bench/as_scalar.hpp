// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "detent/detent.hpp"

namespace detent::bench {

/// A convex hull with its points.
template <Scalar S, int N>
struct Rock {
  std::array<Vec<S, N>, 12> points{};
};
/// The type that queries take: a view of a rock's hull, or the shape itself.
template <Scalar S, int N>
ConvexHull<S, N> as_shape(const Rock<S, N>& rock) {
  return {rock.points};
}
template <class Shape>
const Shape& as_shape(const Shape& shape) {
  return shape;
}

// A scene is drawn in double on a grid that every scalar has: `as<S>` is the same scene in S. It
// rounds to nearest what S cannot represent: components of directions.

template <Number T>
T as_number(double x) {
  if constexpr (is_fixed<T>) {
    return T::from_double(x);
  } else {
    return static_cast<T>(x);
  }
}

template <Number T, Number From, int N>
Vec<T, N> as_vec(const Vec<From, N>& v) {
  return make_vec<N>([&](int i) { return as_number<T>(static_cast<double>(v[i])); });
}

template <Scalar S, int N>
Vec<S, N> as(const Vec<double, N>& v) {
  return as_vec<S>(v);
}
template <Scalar S, int N>
Direction<S, N> as(const Direction<double, N>& d) {
  return Direction<S, N>::assume_unit(as_vec<direction_component<S>>(d.vec()));
}
template <Scalar S, int N>
Rotation<S, N> as(const Rotation<double, N>& rotation) {
  std::array<Direction<S, N>, N> axes;
  for (int i = 0; i < N; ++i) axes[static_cast<std::size_t>(i)] = as<S>(rotation.axis(i));
  return Rotation<S, N>::from_axes(axes);
}
template <Scalar S, int N>
Ray<S, N> as(const Ray<double, N>& ray) {
  return {as<S>(ray.origin), as<S>(ray.direction), as_number<S>(ray.max_distance)};
}
template <Scalar S, int N>
Segment<S, N> as(const Segment<double, N>& segment) {
  return {as<S>(segment.start), as<S>(segment.end)};
}
template <Scalar S, int N>
Sphere<S, N> as(const Sphere<double, N>& sphere) {
  return {as<S>(sphere.center), as_number<S>(sphere.radius)};
}
template <Scalar S, int N>
Aabb<S, N> as(const Aabb<double, N>& box) {
  return {as<S>(box.min), as<S>(box.max)};
}
template <Scalar S, int N>
Obb<S, N> as(const Obb<double, N>& box) {
  return {as<S>(box.center), as<S>(box.half_extents), as<S>(box.rotation)};
}
template <Scalar S, int N>
Plane<S, N> as(const Plane<double, N>& plane) {
  return {as<S>(plane.normal), as_number<S>(plane.offset)};
}
template <Scalar S, int N>
Triangle<S, N> as(const Triangle<double, N>& triangle) {
  return {as<S>(triangle.a), as<S>(triangle.b), as<S>(triangle.c)};
}
template <Scalar S, int N>
Capsule<S, N> as(const Capsule<double, N>& capsule) {
  return {as<S>(capsule.a), as<S>(capsule.b), as_number<S>(capsule.radius)};
}
template <Scalar S, int N>
Rock<S, N> as(const Rock<double, N>& rock) {
  Rock<S, N> result;
  for (std::size_t i = 0; i < rock.points.size(); ++i) result.points[i] = as<S>(rock.points[i]);
  return result;
}

/// A shape moved by `offset`, for shapes in double.
template <int N>
void move(Vec<double, N>& v, const Vec<double, N>& offset) {
  v += offset;
}
template <int N>
void move(Segment<double, N>& segment, const Vec<double, N>& offset) {
  segment = {segment.start + offset, segment.end + offset};
}
template <int N>
void move(Ray<double, N>& ray, const Vec<double, N>& offset) {
  ray.origin += offset;
}
template <int N>
void move(Sphere<double, N>& sphere, const Vec<double, N>& offset) {
  sphere.center += offset;
}
template <int N>
void move(Aabb<double, N>& box, const Vec<double, N>& offset) {
  box = {box.min + offset, box.max + offset};
}
template <int N>
void move(Obb<double, N>& box, const Vec<double, N>& offset) {
  box.center += offset;
}
/// A plane moves along its normal, so that its offset stays on the grid.
template <int N>
void move(Plane<double, N>& plane, const Vec<double, N>& offset) {
  for (int i = 0; i < N; ++i) plane.offset += offset[i];
}
template <int N>
void move(Triangle<double, N>& triangle, const Vec<double, N>& offset) {
  triangle = {triangle.a + offset, triangle.b + offset, triangle.c + offset};
}
template <int N>
void move(Rock<double, N>& rock, const Vec<double, N>& offset) {
  for (auto& point : rock.points) point += offset;
}
template <int N>
void move(Capsule<double, N>& capsule, const Vec<double, N>& offset) {
  capsule = {capsule.a + offset, capsule.b + offset, capsule.radius};
}

}  // namespace detent::bench
