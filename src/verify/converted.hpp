// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "detent/math/rotation.hpp"
#include "detent/shape/shape.hpp"
#include "support/shapes.hpp"
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
  return support::mapped_axes<T>(rotation, [](const auto& axis) { return converted<T>(axis); });
}

template <Scalar T, support::Mappable Shape>
auto converted(const Shape& shape) {
  return support::mapped(shape, [](const auto& field) { return converted<T>(field); });
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
