// SPDX-License-Identifier: MIT
#include "detent/dynamics/follow.hpp"
using namespace detent;

// Aligned boxes turn in a world, so the scene needs Obb.
void update(Scene<q16_16, 3, Aabb>& scene, const World<q16_16, 3, Aabb>& world) {
  follow(scene, world);
}
