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

template <class F>
bool converted(bool answer) {
  return answer;
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
Transform<F, N> converted(const Transform<S, N>& transform) {
  return {converted<F>(transform.translation), converted<F>(transform.rotation),
          converted<F>(transform.scale)};
}

template <class F, template <Scalar, int> class Case, Scalar S, int N>
requires requires { Case<S, N>::field_names; }
Case<F, N> in_float(const Case<S, N>& c) {
  return c.fields([](const auto&... fields) { return Case<F, N>{converted<F>(fields)...}; });
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
CrossingCase<F, N> in_float(const CrossingCase<S, N>& c) {
  CrossingCase<F, N> result;
  for (std::size_t i = 0; i < c.planes.size(); ++i) result.planes[i] = converted<F>(c.planes[i]);
  return result;
}

}  // namespace detent::verify
