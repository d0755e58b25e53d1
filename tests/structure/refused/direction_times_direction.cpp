// SPDX-License-Identifier: MIT
#include "detent/math/math.hpp"
#include "detent/number/number.hpp"

using namespace detent;
using namespace detent::literals;

auto cosine(Direction<q16_16, 3> a, Direction<q16_16, 3> b) { return a * b; }
