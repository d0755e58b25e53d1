// SPDX-License-Identifier: MIT
#include "detent/number/number.hpp"

using namespace detent;

float screen(q16_16 x) { return nearest_to<float>(x); }
