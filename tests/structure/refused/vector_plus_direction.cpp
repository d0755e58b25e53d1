// SPDX-License-Identifier: MIT
#include "detent/math/math.hpp"
#include "detent/number/number.hpp"

using namespace detent;
using namespace detent::literals;

auto step(Vec<q16_16, 3> p, Direction<q16_16, 3> d) { return p + d; }
