// SPDX-License-Identifier: MIT
#include "detent/math/math.hpp"
#include "detent/number/number.hpp"

using namespace detent;
using namespace detent::literals;

q16_16 product(q16_16 a, q16_16 b) { return q16_16(a * b); }
