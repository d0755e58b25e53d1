// SPDX-License-Identifier: MIT
#include "detent/scene/scene.hpp"
using namespace detent;

auto all(const Scene<q16_16, 3, Sphere>& scene) { return scene.all(Triangle<q16_16, 3>{}); }
