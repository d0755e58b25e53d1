// SPDX-License-Identifier: MIT
#include "detent/dynamics/world.hpp"
using namespace detent;

void fill(World<q16_16, 3, Sphere>& world) { world.add(HingeJoint<q16_16, 3>{}); }
