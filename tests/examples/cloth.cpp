// SPDX-License-Identifier: MIT
// A cloth falls on a ball, and a heavy rope hangs from a corner of a moving box. No particle ever
// touches the ball; `overlaps` decides that exactly.
#include <detent/dynamics/dynamics.hpp>
#include <detent/number/literals.hpp>
#include <detent/query/overlaps.hpp>
using namespace detent;
using namespace detent::literals;

using Point = Vec<q16_16, 3>;

int main() {
  ParticleSettings<q16_16, 3> settings;
  settings.damping = 1_q16_16;
  ParticleSystem<q16_16, 3> system(settings);

  FabricOptions<q16_16, 3> linen;
  linen.bend = 5_q16_16;  // hertz
  const auto cloth = add_cloth(system, Point{-1_q16_16, 1.5_q16_16, -1_q16_16},
                               Point{0.25_q16_16, 0_q16_16, 0_q16_16},
                               Point{0_q16_16, 0_q16_16, 0.25_q16_16}, 9, 9, linen);

  FabricOptions<q16_16, 3> cord;
  cord.has_tethers = true;
  const auto rope = add_rope(system, Point{5_q16_16, 4_q16_16, 0_q16_16},
                             Point{7_q16_16, 4_q16_16, 0_q16_16}, 9, cord);
  if (!cloth || !rope) return 1;
  system.set_pinned(rope->first, true);

  World<q16_16, 3, Obb, Sphere> world;
  BodyOptions<q16_16, 3> lift;
  lift.motion = BodyMotion::kinematic;
  lift.velocity = {0_q16_16, 0.5_q16_16, 0_q16_16};
  const Point half{0.5_q16_16, 0.5_q16_16, 0.5_q16_16};
  const auto box = world.add(Obb<q16_16, 3>{{5_q16_16, 4.5_q16_16, 0_q16_16}, half, {}}, lift);
  const Sphere<q16_16, 3> ball{{0_q16_16, 0_q16_16, 0_q16_16}, 1_q16_16};
  if (!box) return 1;

  for (int tick = 0; tick < 240; ++tick) {
    world.step();
    const Point below{0_q16_16, -0.7_q16_16, 0_q16_16};
    system.move_to(rope->first, nearest_to<q16_16>(world.position(*box) + below));
    const auto bodies = obstacles_of(world);
    system.step(obstacles<q16_16, 3>(ball, bodies));
    for (ParticleIndex i = 0; i < system.size(); ++i) {
      if (overlaps(system.ball(i), ball)) return 1;
    }
  }
  const auto middle = system.position(cloth->at(4, 4));
  if (middle.y < 1.04_q16_16 || middle.y > 1.06_q16_16) return 1;  // on the ball, 0.05 above it
  const auto reach = distance(system.position(rope->first), system.position(rope->last()));
  return reach < 2.01_q16_16 ? 0 : 1;
}
