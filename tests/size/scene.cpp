// SPDX-License-Identifier: MIT
// A scene of three shapes and one query. `./dev size compile` measures its compile time.

#include "detent/scene/scene.hpp"

using namespace detent;

int main() {
  Scene<q16_16, 3, Sphere, Aabb, Capsule> scene;
  static_cast<void>(scene.add(Sphere{Vec<q16_16, 3>{q16_16(9), {}, {}}, q16_16(1)}));
  const Ray ray{Vec<q16_16, 3>{}, Direction<q16_16, 3>::along(0)};
  const auto found = scene.nearest(ray);
  return found && found->distance == 8 ? 0 : 1;
}
