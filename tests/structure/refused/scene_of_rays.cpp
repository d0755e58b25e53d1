// SPDX-License-Identifier: MIT
#include "detent/scene/scene.hpp"

detent::Scene<detent::q16_16, 3, detent::Ray> scene;
