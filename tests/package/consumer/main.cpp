// SPDX-License-Identifier: MIT
#include <detent/detent.hpp>

int main() {
  using namespace detent;
  const Sphere<q16_16, 3> sphere{{q16_16(0), q16_16(0), q16_16(10)}, q16_16(2)};
  const auto forward = normalize(Vec<q16_16, 3>{q16_16(0), q16_16(0), q16_16(1)});
  const Ray<q16_16, 3> ray{{}, *forward, q16_16(100)};
  const auto hit = raycast_hit(ray, sphere);
  Scene<q16_16, 3, Sphere, Capsule> scene;
  if (!scene.add(sphere) || scene.nearest_hit(ray)->distance != 8) return 1;
  return hit && hit->distance == 8 && raycast(ray, sphere) == q16_16(8) ? 0 : 1;
}
