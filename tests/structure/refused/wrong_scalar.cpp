// SPDX-License-Identifier: MIT
#include "detent/detent.hpp"

detent::Sphere<int, 3> sphere;
