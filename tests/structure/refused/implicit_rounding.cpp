// SPDX-License-Identifier: MIT
#include "detent/number/fixed.hpp"

constexpr detent::q16_16 a(2), b(3);
constexpr detent::q16_16 product = a * b;
