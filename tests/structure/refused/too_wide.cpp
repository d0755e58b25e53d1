// SPDX-License-Identifier: MIT
#include "detent/number/fixed.hpp"

constexpr detent::Fixed<320, 0> x;
constexpr auto product = x * x;
