// SPDX-License-Identifier: MIT
#include "detent/scene/scene.hpp"
using namespace detent;

void fill() {
  Scene<q16_16, 3> scene;
  scene.add(Sphere<q16_16, 3>{});
}
