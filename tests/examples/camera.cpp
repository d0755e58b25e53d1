// SPDX-License-Identifier: MIT
// What is under the mouse, and where on the screen is a world point?
#include <detent/detent.hpp>
using namespace detent;
using namespace detent::literals;

int main() {
  using Vec3 = Vec<q16_16, 3>;
  // 60 degrees from top to bottom, 16:9, from 0.1 to 500 units.
  const auto lens =
      Lens<q16_16>::perspective(Angle<q16_16>::from_degrees(60_q16_16),
                                quotient_nearest<q16_16>(16, 9), 0.1_q16_16, 500_q16_16);
  if (!lens) return 1;
  OrbitCamera<q16_16> orbit{*lens, Vec3{}, 20_q16_16};
  orbit.rotate(Angle<q16_16>::from_degrees(30_q16_16), Angle<q16_16>::from_degrees(20_q16_16));
  orbit.zoom(1.5_q16_16);
  const Camera camera = orbit.camera();

  Scene<q16_16, 3, Sphere> scene;
  const auto ball = scene.add(Sphere{Vec3{}, 1_q16_16});
  const Viewport screen{1920, 1080};
  const auto hit = scene.nearest_hit(pick_ray(camera, screen, 960, 540));
  const auto seen = project(camera, screen, Vec3{});
  return hit && hit->id == ball && seen && floor_to<int>(seen->x) == 960 ? 0 : 1;
}
