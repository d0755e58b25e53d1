// SPDX-License-Identifier: MIT
#pragma once

#include "detent/number/scalar.hpp"
#include "support/scalars.hpp"

namespace detent::test {

/// A scalar and a dimension, so that the names of test cases show both.
template <Scalar S, int N>
struct Space {
  using scalar = S;
  static constexpr int dimension = N;
};

}  // namespace detent::test

/// The arguments of TEMPLATE_TEST_CASE; with a type list, the test names would lose the types.
/// Everyday runs use the widest and the narrowest scalar, one in each dimension. DETENT_TEST_ALL
/// uses these in both dimensions; DETENT_TEST_EVERY_SPACE uses every scalar in both. The everyday
/// spaces by name are for examples of queries that would otherwise take minutes to compile, and
/// whose oracles run in all spaces. DETENT_SLOW_SCALARS are for sources that take half a minute
/// to compile in two scalars: everyday runs use one. DETENT_FILTER_SCALARS are for tests of
/// filters, which q8_8 hardly uses, and whose code is the same in the other scalars.
#define DETENT_SPACE(name, dimension) (detent::test::Space<name, dimension>)
#define DETENT_SPACES_OF(name) DETENT_SPACE(detent::name, 3), DETENT_SPACE(detent::name, 2)
#define DETENT_EVERYDAY_FIXED_SPACES DETENT_SPACE(detent::q16_16, 3), DETENT_SPACE(detent::q8_8, 2)
#define DETENT_EVERYDAY_SPACES DETENT_EVERYDAY_FIXED_SPACES, DETENT_SPACE(float, 3)
#if DETENT_TEST_EVERY_SPACE
#define DETENT_SLOW_SCALARS detent::q16_16, detent::q8_8
#define DETENT_FILTER_SCALARS detent::q16_16, detent::q14_16, detent::q24_8
#define DETENT_FIXED_SCALARS DETENT_EACH_FIXED_SCALAR(DETENT_SCALAR_TYPE)
#define DETENT_EVERY_SCALAR DETENT_FIXED_SCALARS, float, double
#define DETENT_FIXED_SPACES DETENT_EACH_FIXED_SCALAR(DETENT_SPACES_OF)
#define DETENT_EVERY_SPACE                                                                      \
  DETENT_FIXED_SPACES, DETENT_SPACE(float, 3), DETENT_SPACE(float, 2), DETENT_SPACE(double, 3), \
      DETENT_SPACE(double, 2)
#elif DETENT_TEST_ALL
#define DETENT_SLOW_SCALARS detent::q16_16, detent::q8_8
#define DETENT_FILTER_SCALARS detent::q16_16
#define DETENT_FIXED_SCALARS detent::q16_16, detent::q8_8
#define DETENT_EVERY_SCALAR DETENT_FIXED_SCALARS, float, double
#define DETENT_FIXED_SPACES DETENT_SPACES_OF(q16_16), DETENT_SPACES_OF(q8_8)
#define DETENT_EVERY_SPACE DETENT_FIXED_SPACES, DETENT_SPACE(float, 3), DETENT_SPACE(double, 2)
#else
#define DETENT_SLOW_SCALARS detent::q16_16
#define DETENT_FILTER_SCALARS detent::q16_16
#define DETENT_FIXED_SCALARS detent::q16_16, detent::q8_8
#define DETENT_EVERY_SCALAR DETENT_FIXED_SCALARS, float
#define DETENT_FIXED_SPACES DETENT_EVERYDAY_FIXED_SPACES
#define DETENT_EVERY_SPACE DETENT_EVERYDAY_SPACES
#endif
