// SPDX-License-Identifier: MIT
#pragma once

#include <numbers>
#include <type_traits>

#include "verify/converted.hpp"
#include "verify/questions.hpp"

namespace detent::verify {

// Cases of a fixed scalar as cases of `float` or `double`.

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
