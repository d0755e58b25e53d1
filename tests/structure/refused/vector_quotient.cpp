// SPDX-License-Identifier: MIT
#include "detent/math/math.hpp"
#include "detent/number/number.hpp"

using namespace detent;
using namespace detent::literals;

auto middle(Vec<q16_16, 3> v) { return v / 2; }
