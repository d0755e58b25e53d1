// SPDX-License-Identifier: MIT
#pragma once

#include <numbers>
#include <type_traits>

#include "verify/converted.hpp"
#include "verify/questions.hpp"

namespace detent::verify {

// Converts cases of a fixed scalar to `float` or `double`.

template <class F, Scalar S>
Angle<F> converted(Angle<S> angle) {
  const double turns = static_cast<double>(Fixed<32, 32>::from_raw(angle.raw()));
  return Angle<F>::from_raw(
      static_cast<F>((turns > 0.5 ? turns - 1 : turns) * (2 * std::numbers::pi)));
}

template <class F, Scalar S, int N, class Shape>
auto in_float(const RayCase<S, N, Shape>& c) {
  const auto shape = converted<F>(c.shape);
  using FloatShape = std::remove_const_t<decltype(shape)>;
  return RayCase<F, N, FloatShape>{converted<F>(c.ray), shape, c.facing};
}
template <class F, Scalar S, int N, class Shape>
auto in_float(const PointCase<S, N, Shape>& c) {
  const auto shape = converted<F>(c.shape);
  using FloatShape = std::remove_const_t<decltype(shape)>;
  return PointCase<F, N, FloatShape>{shape, converted<F>(c.point), converted<F>(c.tolerance)};
}
template <class F, Scalar S, int N, class First, class Second>
auto in_float(const PairCase<S, N, First, Second>& c) {
  const auto a = converted<F>(c.a);
  const auto b = converted<F>(c.b);
  return PairCase<F, N, std::remove_const_t<decltype(a)>, std::remove_const_t<decltype(b)>>{a, b};
}
template <class F, Scalar S, int N>
VectorCase<F, N> in_float(const VectorCase<S, N>& c) {
  return {converted<F>(c.vector)};
}
template <class F, Scalar S, int N>
AngleCase<F, N> in_float(const AngleCase<S, N>& c) {
  return {converted<F>(c.angle), converted<F>(c.number)};
}
template <class F, Scalar S, int N>
BearingCase<F, N> in_float(const BearingCase<S, N>& c) {
  return {converted<F>(c.y), converted<F>(c.x)};
}
template <class F, Scalar S, int N>
TurnCase<F, N> in_float(const TurnCase<S, N>& c) {
  return {converted<F>(c.axis), converted<F>(c.angle)};
}
template <class F, Scalar S, int N>
QuaternionCase<F, N> in_float(const QuaternionCase<S, N>& c) {
  return {converted<F>(c.x), converted<F>(c.y), converted<F>(c.z), converted<F>(c.w)};
}
template <class F, Scalar S, int N>
EulerCase<F, N> in_float(const EulerCase<S, N>& c) {
  return {converted<F>(c.x), converted<F>(c.y), converted<F>(c.z)};
}
template <class F, Scalar S, int N>
RotateCase<F, N> in_float(const RotateCase<S, N>& c) {
  return {converted<F>(c.rotation), converted<F>(c.vector)};
}
template <class F, Scalar S, int R, int C>
Mat<F, R, C> converted(const Mat<S, R, C>& m) {
  return make_mat<R, C>([&](int i, int j) { return converted<F>(m(i, j)); });
}
template <class F, Scalar S>
Quat<F> converted(const Quat<S>& q) {
  return Quat<F>::assume_unit(converted<F>(q.vec()));
}
template <class F, Scalar S, int N>
MatrixCase<F, N> in_float(const MatrixCase<S, N>& c) {
  return {converted<F>(c.matrix)};
}
template <class F, Scalar S, int N>
BlendCase<F, N> in_float(const BlendCase<S, N>& c) {
  return {converted<F>(c.p), converted<F>(c.q), converted<F>(c.t), converted<F>(c.vector)};
}
template <class F, Scalar S, int N>
MotionCase<F, N> in_float(const MotionCase<S, N>& c) {
  return {{converted<F>(c.transform.translation), converted<F>(c.transform.rotation),
           converted<F>(c.transform.scale)},
          converted<F>(c.point)};
}
template <class F, Scalar S, int N>
CameraCase<F, N> in_float(const CameraCase<S, N>& c) {
  return {converted<F>(c.eye), converted<F>(c.target), converted<F>(c.up), converted<F>(c.matrix)};
}
template <class F, Scalar S, int N>
LensCase<F, N> in_float(const LensCase<S, N>& c) {
  return {converted<F>(c.fov), converted<F>(c.aspect), converted<F>(c.near_distance),
          converted<F>(c.far_distance)};
}
template <class F, Scalar S, int N>
ViewCase<F, N> in_float(const ViewCase<S, N>& c) {
  return {
      {converted<F>(c.pose.translation), converted<F>(c.pose.rotation), converted<F>(c.pose.scale)},
      c.narrows,
      converted<F>(c.fov),
      converted<F>(c.width),
      converted<F>(c.height),
      converted<F>(c.near_distance),
      converted<F>(c.far_distance),
      converted<F>(c.point),
      converted<F>(c.x),
      converted<F>(c.y),
      converted<F>(c.depth),
      converted<F>(c.box)};
}
template <class F, Scalar S, int N>
VectorsCase<F, N> in_float(const VectorsCase<S, N>& c) {
  return {converted<F>(c.u), converted<F>(c.v), converted<F>(c.normal), converted<F>(c.t)};
}
template <class F, Scalar S, int N>
CrossingCase<F, N> in_float(const CrossingCase<S, N>& c) {
  CrossingCase<F, N> result;
  for (std::size_t i = 0; i < c.planes.size(); ++i) result.planes[i] = converted<F>(c.planes[i]);
  return result;
}
template <class F, Scalar S, int N>
SizeCase<F, N> in_float(const SizeCase<S, N>& c) {
  return {converted<F>(c.triangle), converted<F>(c.aabb), converted<F>(c.sphere),
          converted<F>(c.obb)};
}
template <class F, Scalar S, int N>
RootCase<F, N> in_float(const RootCase<S, N>& c) {
  return {converted<F>(c.a), converted<F>(c.b), converted<F>(c.beside_square),
          converted<F>(c.beside_fourth_power)};
}
template <class F, Scalar S, int N>
QuotientCase<F, N> in_float(const QuotientCase<S, N>& c) {
  return {converted<F>(c.a), converted<F>(c.b), converted<F>(c.c), converted<F>(c.d)};
}

}  // namespace detent::verify
