// SPDX-License-Identifier: MIT
#include "detent/number/fixed.hpp"

constexpr detent::Fixed<255, 0> x;
constexpr auto product = x * x;
