// SPDX-License-Identifier: MIT
#include "detent/dynamics/world.hpp"
using namespace detent;

void fill() {
  World<q16_16, 3, BallJoint> world;
  world.add(Sphere<q16_16, 3>{});
}
