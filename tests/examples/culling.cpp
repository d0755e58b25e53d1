// SPDX-License-Identifier: MIT
// Which objects does a camera see? A scene can be queried with a frustum as with a sphere or box.
#include <detent/detent.hpp>
using namespace detent;
using namespace detent::literals;

int main() {
  using Vec3 = Vec<q16_16, 3>;
  const auto pose =
      look_at(Vec3{}, Vec3{0_q16_16, 0_q16_16, -1_q16_16}, Vec3{0_q16_16, 1_q16_16, 0_q16_16});
  const auto lens =
      Lens<q16_16>::perspective(Angle<q16_16>::turn(1, 4), 1_q16_16, 1_q16_16, 100_q16_16);
  if (!pose || !lens) return 1;
  const Frustum frustum{Camera{*pose, *lens}};

  Scene<q16_16, 3, Sphere, Aabb> scene;
  const auto ahead = scene.add(Sphere{Vec3{0_q16_16, 0_q16_16, -50_q16_16}, 1_q16_16});
  scene.add(Sphere{Vec3{0_q16_16, 0_q16_16, 50_q16_16}, 1_q16_16});
  scene.add(Aabb{Vec3{11_q16_16, -1_q16_16, -10_q16_16}, Vec3{12_q16_16, 1_q16_16, -9_q16_16}});
  const auto visible = scene.all(frustum);  // the nearest first
  return visible.size() == 1 && visible[0].id == ahead ? 0 : 1;
}
