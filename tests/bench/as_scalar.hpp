// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "detent/detent.hpp"
#include "support/shapes.hpp"

namespace detent::bench {

template <Number T>
T as_number(double x) {
  if constexpr (is_fixed<T>) {
    return T::from_double(x);
  } else {
    return static_cast<T>(x);
  }
}

/// A convex hull that owns its points.
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

/// A shape moving along a direction.
template <Scalar S, int N, template <class, int> class Shape>
struct Moving {
  Shape<S, N> shape{};
  Direction<S, N> direction;
  S max_distance{};
};

/// A shape in the frame that a sweep moves.
template <Scalar S, int N, template <class, int> class Shape>
struct Swept {
  Shape<S, N> shape{};
  Sweep<S, N> sweep{};
};

/// A camera that sees 60 degrees from top to bottom, on a screen of 1890 x 1080 pixels: 7 : 4, which
/// every scalar has.
template <Scalar S, int N>
struct View {
  static Lens<S> lens() {
    return *Lens<S>::perspective(Angle<S>::turn(1, 6), as_number<S>(1.75), S(1), S(100));
  }
  static constexpr Viewport screen{1890, 1080};

  Camera<S> camera{{}, lens()};
};
/// A pixel of the screen.
template <Scalar S, int N>
struct Pixel {
  std::int32_t column = 0, row = 0;
};
/// A point of the screen, in screen coordinates.
template <Scalar S, int N>
struct Spot {
  S x{}, y{};
};

// A scene is drawn in double on a grid that every scalar has. `as<S>` is the same scene in S.
// Directions that S cannot represent are rounded to nearest.

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
template <Scalar S>
S as(const double& x) {
  return as_number<S>(x);
}
template <Scalar S, int N>
Rotation<S, N> as(const Rotation<double, N>& rotation) {
  return support::mapped_axes<S>(rotation, [](const auto& axis) { return as<S>(axis); });
}
template <Scalar S, support::Mappable Shape>
auto as(const Shape& shape) {
  return support::mapped(shape, [](const auto& field) { return as<S>(field); });
}
template <Scalar S, int N>
Rock<S, N> as(const Rock<double, N>& rock) {
  Rock<S, N> result;
  for (std::size_t i = 0; i < rock.points.size(); ++i) result.points[i] = as<S>(rock.points[i]);
  return result;
}
template <Scalar S, int N, template <class, int> class Shape>
Moving<S, N, Shape> as(const Moving<double, N, Shape>& moving) {
  return {as<S>(moving.shape), as<S>(moving.direction), as<S>(moving.max_distance)};
}
template <Scalar S, int N, template <class, int> class Shape>
Swept<S, N, Shape> as(const Swept<double, N, Shape>& body) {
  const auto& [start, end, start_rotation, end_rotation] = body.sweep;
  return {as<S>(body.shape),
          {as<S>(start), as<S>(end), as<S>(start_rotation), as<S>(end_rotation)}};
}
template <Scalar S, int N>
View<S, N> as(const View<double, N>& view) {
  const auto& pose = view.camera.pose;
  View<S, N> result;
  result.camera.pose = {as<S>(pose.translation), as<S>(pose.rotation)};
  return result;
}
template <Scalar S, int N>
Pixel<S, N> as(const Pixel<double, N>& pixel) {
  return {pixel.column, pixel.row};
}
template <Scalar S, int N>
Spot<S, N> as(const Spot<double, N>& spot) {
  return {as<S>(spot.x), as<S>(spot.y)};
}

/// A shape in double moved by `offset`.
template <int N>
void move(Vec<double, N>& v, const Vec<double, N>& offset) {
  v += offset;
}
template <template <Scalar, int> class Shape, int N>
requires support::OfPoints<Shape<double, N>>
void move(Shape<double, N>& shape, const Vec<double, N>& offset) {
  shape = support::with_points(shape, [&](const auto& point) { return point + offset; });
}
template <int N>
void move(Ray<double, N>& ray, const Vec<double, N>& offset) {
  ray.origin += offset;
}
template <int N>
void move(Aabb<double, N>& box, const Vec<double, N>& offset) {
  box = {box.min + offset, box.max + offset};
}
template <int N>
void move(Obb<double, N>& box, const Vec<double, N>& offset) {
  box.center += offset;
}
/// A plane moves along its normal, so its offset stays on the grid.
template <int N>
void move(Plane<double, N>& plane, const Vec<double, N>& offset) {
  for (int i = 0; i < N; ++i) plane.offset += offset[i];
}
template <int N>
void move(Rock<double, N>& rock, const Vec<double, N>& offset) {
  for (auto& point : rock.points) point += offset;
}
template <template <class, int> class Shape, int N>
void move(Swept<double, N, Shape>& body, const Vec<double, N>& offset) {
  body.sweep.start += offset;
  body.sweep.end += offset;
}
}  // namespace detent::bench
