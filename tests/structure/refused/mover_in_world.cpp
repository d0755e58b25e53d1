// SPDX-License-Identifier: MIT
#include "detent/dynamics/world.hpp"
#include "detent/scene/mover.hpp"
using namespace detent;

void walk(Mover<q16_16, 3, Capsule>& player, const World<q16_16, 3, Sphere>& world) {
  player.move(world, {});
}
