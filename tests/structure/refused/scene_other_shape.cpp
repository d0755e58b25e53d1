// SPDX-License-Identifier: MIT
#include "detent/scene/scene.hpp"
using namespace detent;

void fill(Scene<q16_16, 3, Sphere>& scene) { scene.add(Aabb<q16_16, 3>{}, {.layers = 2}); }
