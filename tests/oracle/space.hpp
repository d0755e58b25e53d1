// SPDX-License-Identifier: MIT
#pragma once

#include "detent/number/scalar.hpp"

namespace detent::test {

/// A scalar and a dimension, so that the names of test cases show both.
template <Scalar S, int N>
struct Space {
  using scalar = S;
  static constexpr int dimension = N;
};

}  // namespace detent::test

/// The arguments of TEMPLATE_TEST_CASE; with a type list, the test names would lose the types.
#define DETENT_FIXED_SPACES                                                               \
  (detent::test::Space<detent::q16_16, 3>), (detent::test::Space<detent::q16_16, 2>),     \
      (detent::test::Space<detent::q14_16, 3>), (detent::test::Space<detent::q14_16, 2>), \
      (detent::test::Space<detent::q24_8, 3>), (detent::test::Space<detent::q24_8, 2>),   \
      (detent::test::Space<detent::q8_8, 3>), (detent::test::Space<detent::q8_8, 2>)
#define DETENT_EVERY_SPACE                                                               \
  DETENT_FIXED_SPACES, (detent::test::Space<float, 3>), (detent::test::Space<float, 2>), \
      (detent::test::Space<double, 3>), (detent::test::Space<double, 2>)
