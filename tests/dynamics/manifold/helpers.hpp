// SPDX-License-Identifier: MIT
#pragma once

#include "detent/dynamics/manifold/pair.hpp"
#include "query/raycast/helpers.hpp"

namespace detent::test {

using detail::manifold;

template <Scalar S>
using ratio = typename detail::Formats<S>::Ratio;
template <Scalar S>
using lever = typename detail::Formats<S>::Lever;

/// `value` as a number of this type.
template <Number T>
constexpr T as(double value) {
  if constexpr (is_fixed<T>) {
    return T::from_double(value);
  } else {
    return static_cast<T>(value);
  }
}

template <Scalar S>
constexpr auto gap(double value) {
  return as<typename detail::Formats<S>::Gap>(value);
}

/// The point (x, y, z), or (x, y) in 2D, in the frame of a body.
template <Scalar S, int N>
constexpr Vec<lever<S>, N> levers(double x, double y, double z = 0) {
  return make_vec<N>([&](int i) { return as<lever<S>>(i == 0 ? x : i == 1 ? y : z); });
}

/// The pose of a body without rotation.
template <Scalar S, int N>
constexpr detail::RelativePose<S, N> shifted(double x, double y, double z = 0) {
  detail::RelativePose<S, N> pose;
  for (int i = 0; i < N; ++i) {
    pose.axes[static_cast<std::size_t>(i)] = detail::unit_axis<ratio<S>, N>(i);
  }
  pose.translation = levers<S, N>(x, y, z);
  return pose;
}

}  // namespace detent::test
