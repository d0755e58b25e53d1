// SPDX-License-Identifier: MIT
#include "detent/math/math.hpp"
#include "detent/number/number.hpp"

using namespace detent;
using namespace detent::literals;

bool is_steep(q16_16 rise, q16_16 run) { return rise / run > 1; }
