// SPDX-License-Identifier: MIT
#include "detent/number/rounding.hpp"

constexpr auto root = detent::sqrt_floor<detent::q16_16>(detent::Fixed<200, 0>(2));
