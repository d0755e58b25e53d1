// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <numbers>
#include <type_traits>

#include "verify/questions.hpp"

namespace detent::verify {

// Cases of a fixed scalar as cases of `float` or `double`: every number the nearest one, with a
// single conversion and nothing computed that could come out differently elsewhere.

template <class F, int Bits, int Frac>
F in_float(const Fixed<Bits, Frac>& x) {
  return static_cast<F>(static_cast<double>(x));  // a double holds x
}
template <class F, Scalar S>
Angle<F> in_float(Angle<S> angle) {
  const double turns = static_cast<double>(Fixed<32, 32>::from_raw(angle.raw()));
  return Angle<F>::from_raw(
      static_cast<F>((turns > 0.5 ? turns - 1 : turns) * (2 * std::numbers::pi)));
}
template <class F, Number T, int N>
Vec<F, N> in_float(const Vec<T, N>& v) {
  return make_vec<N>([&](int i) { return in_float<F>(v[i]); });
}
template <class F, Scalar S, int N>
Direction<F, N> in_float(const Direction<S, N>& direction) {
  return Direction<F, N>::assume_unit(in_float<F>(direction.vec()));
}
template <class F, Scalar S, int N>
Rotation<F, N> in_float(const Rotation<S, N>& rotation) {
  std::array<Direction<F, N>, N> axes;
  for (int i = 0; i < N; ++i) axes[static_cast<std::size_t>(i)] = in_float<F>(rotation.axis(i));
  return Rotation<F, N>::from_axes(axes);
}

template <class F, Scalar S, int N>
Sphere<F, N> in_float(const Sphere<S, N>& s) {
  return {in_float<F>(s.center), in_float<F>(s.radius)};
}
template <class F, Scalar S, int N>
Aabb<F, N> in_float(const Aabb<S, N>& s) {
  return {in_float<F>(s.min), in_float<F>(s.max)};
}
template <class F, Scalar S, int N>
Obb<F, N> in_float(const Obb<S, N>& s) {
  return {in_float<F>(s.center), in_float<F>(s.half_extents), in_float<F>(s.rotation)};
}
template <class F, Scalar S, int N>
Plane<F, N> in_float(const Plane<S, N>& s) {
  return {in_float<F>(s.normal), in_float<F>(s.offset)};
}
template <class F, Scalar S, int N>
Triangle<F, N> in_float(const Triangle<S, N>& s) {
  return {in_float<F>(s.a), in_float<F>(s.b), in_float<F>(s.c)};
}
template <class F, Scalar S, int N>
Ray<F, N> in_float(const Ray<S, N>& ray) {
  return {in_float<F>(ray.origin), in_float<F>(ray.direction), in_float<F>(ray.max_distance)};
}

template <class F, Scalar S, int N, class Shape>
auto in_float(const RayCase<S, N, Shape>& c) {
  const auto shape = in_float<F>(c.shape);
  using FloatShape = std::remove_const_t<decltype(shape)>;
  return RayCase<F, N, FloatShape>{in_float<F>(c.ray), shape, c.facing};
}
template <class F, Scalar S, int N>
VectorCase<F, N> in_float(const VectorCase<S, N>& c) {
  return {in_float<F>(c.vector)};
}
template <class F, Scalar S, int N>
AngleCase<F, N> in_float(const AngleCase<S, N>& c) {
  return {in_float<F>(c.angle), in_float<F>(c.number)};
}
template <class F, Scalar S, int N>
PointCase<F, N> in_float(const PointCase<S, N>& c) {
  return {in_float<F>(c.y), in_float<F>(c.x)};
}
template <class F, Scalar S, int N>
TurnCase<F, N> in_float(const TurnCase<S, N>& c) {
  return {in_float<F>(c.axis), in_float<F>(c.angle)};
}
template <class F, Scalar S, int N>
QuaternionCase<F, N> in_float(const QuaternionCase<S, N>& c) {
  return {in_float<F>(c.x), in_float<F>(c.y), in_float<F>(c.z), in_float<F>(c.w)};
}
template <class F, Scalar S, int N>
EulerCase<F, N> in_float(const EulerCase<S, N>& c) {
  return {in_float<F>(c.x), in_float<F>(c.y), in_float<F>(c.z)};
}
template <class F, Scalar S, int N>
RotateCase<F, N> in_float(const RotateCase<S, N>& c) {
  return {in_float<F>(c.rotation), in_float<F>(c.vector)};
}
template <class F, Scalar S, int N>
RootCase<F, N> in_float(const RootCase<S, N>& c) {
  return {in_float<F>(c.a), in_float<F>(c.b), in_float<F>(c.beside_square),
          in_float<F>(c.beside_fourth_power)};
}
template <class F, Scalar S, int N>
QuotientCase<F, N> in_float(const QuotientCase<S, N>& c) {
  return {in_float<F>(c.a), in_float<F>(c.b), in_float<F>(c.c), in_float<F>(c.d)};
}

}  // namespace detent::verify
