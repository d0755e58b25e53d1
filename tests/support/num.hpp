// SPDX-License-Identifier: MIT
#pragma once

#include "detent/math/vec.hpp"

namespace detent::test {

/// A test's number in any scalar, rounded to nearest.
template <Scalar S>
constexpr S num(double value) {
  if constexpr (is_fixed<S>) {
    return S::from_double(value);
  } else {
    return static_cast<S>(value);
  }
}

/// The point (x, y, z), or (x, y) in 2D.
template <Scalar S, int N>
constexpr Vec<S, N> at(double x, double y = 0, double z = 0) {
  if constexpr (N == 2) {
    return {num<S>(x), num<S>(y)};
  } else {
    return {num<S>(x), num<S>(y), num<S>(z)};
  }
}

}  // namespace detent::test
