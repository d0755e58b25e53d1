// SPDX-License-Identifier: MIT
#pragma once

#include "detent/number/scalar.hpp"

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

}  // namespace detent::test
