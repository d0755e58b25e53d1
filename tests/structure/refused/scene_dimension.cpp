// SPDX-License-Identifier: MIT
#include "detent/scene/scene.hpp"
using namespace detent;

auto any(const Scene<q16_16, 3, Sphere>& scene, const Ray<q16_16, 2>& ray) {
  return scene.any(ray);
}
