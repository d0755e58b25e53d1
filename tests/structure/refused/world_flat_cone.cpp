// SPDX-License-Identifier: MIT
#include "detent/dynamics/world.hpp"
using namespace detent;

void fill(World<q16_16, 2, Sphere, ConeJoint>& world) { world.add(ConeJoint<q16_16, 2>{}); }
