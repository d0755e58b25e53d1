// SPDX-License-Identifier: MIT
#include "detent/dynamics/world.hpp"
using namespace detent;

void play(World<q16_16, 3, Sphere>& world) { world.step(1.0 / 60, 4); }
