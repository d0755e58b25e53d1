// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "detent/math/rotation.hpp"
#include "detent/shape/shape.hpp"
#include "verify/draw/shapes.hpp"

namespace detent::verify {

/// Converts to the nearest `float` or `double` in a single conversion, with no computation that
/// could differ between machines; or to another fixed scalar with the same raw bits.
template <Number T, int Bits, int Frac>
T converted(const Fixed<Bits, Frac>& x) {
  if constexpr (is_fixed<T>) {
    return T::from_raw(static_cast<typename T::raw_type>(x.raw()));
  } else {
    return static_cast<T>(static_cast<double>(x));  // a double represents x exactly
  }
}
template <Number T, Number From, int N>
auto converted(const Vec<From, N>& v) {
  return make_vec<N>([&](int i) { return converted<T>(v[i]); });
}
template <Scalar T, Scalar S, int N>
Direction<T, N> converted(const Direction<S, N>& direction) {
  return Direction<T, N>::assume_unit(converted<direction_component<T>>(direction.vec()));
}
template <Scalar T, Scalar S, int N>
Rotation<T, N> converted(const Rotation<S, N>& rotation) {
  std::array<Direction<T, N>, N> axes;
  for (int i = 0; i < N; ++i) axes[static_cast<std::size_t>(i)] = converted<T>(rotation.axis(i));
  return Rotation<T, N>::from_axes(axes);
}

template <Scalar T, Scalar S, int N>
Sphere<T, N> converted(const Sphere<S, N>& s) {
  return {converted<T>(s.center), converted<T>(s.radius)};
}
template <Scalar T, Scalar S, int N>
Aabb<T, N> converted(const Aabb<S, N>& s) {
  return {converted<T>(s.min), converted<T>(s.max)};
}
template <Scalar T, Scalar S, int N>
Obb<T, N> converted(const Obb<S, N>& s) {
  return {converted<T>(s.center), converted<T>(s.half_extents), converted<T>(s.rotation)};
}
template <Scalar T, Scalar S, int N>
Plane<T, N> converted(const Plane<S, N>& s) {
  return {converted<T>(s.normal), converted<T>(s.offset)};
}
template <Scalar T, Scalar S, int N>
Triangle<T, N> converted(const Triangle<S, N>& s) {
  return {converted<T>(s.a), converted<T>(s.b), converted<T>(s.c)};
}
template <Scalar T, Scalar S, int N>
Ray<T, N> converted(const Ray<S, N>& ray) {
  return {converted<T>(ray.origin), converted<T>(ray.direction), converted<T>(ray.max_distance)};
}
template <Scalar T, Scalar S, int N>
Capsule<T, N> converted(const Capsule<S, N>& s) {
  return {converted<T>(s.a), converted<T>(s.b), converted<T>(s.radius)};
}
template <Scalar T, Scalar S, int N>
Segment<T, N> converted(const Segment<S, N>& s) {
  return {converted<T>(s.start), converted<T>(s.end)};
}
template <Scalar T, Scalar S, int N>
HullPoints<T, N> converted(const HullPoints<S, N>& hull) {
  HullPoints<T, N> result;
  result.count = hull.count;
  for (std::size_t i = 0; i < hull.points.size(); ++i) {
    result.points[i] = converted<T>(hull.points[i]);
  }
  return result;
}

}  // namespace detent::verify
