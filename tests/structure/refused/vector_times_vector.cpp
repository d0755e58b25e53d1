// SPDX-License-Identifier: MIT
#include "detent/math/math.hpp"
#include "detent/number/number.hpp"

using namespace detent;
using namespace detent::literals;

auto product(Vec<q16_16, 3> a, Vec<q16_16, 3> b) { return a * b; }
