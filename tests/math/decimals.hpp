// SPDX-License-Identifier: MIT
#pragma once

#include "detent/math/vec.hpp"

// Numbers and vectors of q16_16 from decimals, for tests of constants.

namespace detent::test {

constexpr q16_16 n(double value) { return q16_16::from_double(value); }
constexpr Vec<q16_16, 3> v3(double x, double y, double z) { return {n(x), n(y), n(z)}; }

}  // namespace detent::test
