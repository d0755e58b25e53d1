// SPDX-License-Identifier: MIT
// A ball hits a stack of boxes. Every machine computes the same bits, so two players who step the
// same world can compare 8 bytes.
#include <detent/dynamics/dynamics.hpp>
#include <detent/number/literals.hpp>
using namespace detent;
using namespace detent::literals;

using Bodies = World<q16_16, 2, Sphere, Obb>;
using Box = Obb<q16_16, 2>;

int main() {
  Bodies world;  // 60 ticks a second, 4 substeps, gravity (0, -10)

  BodyOptions<q16_16, 2> ground;
  ground.motion = BodyMotion::fixed;
  world.add(Box{{0_q16_16, -1_q16_16}, {50_q16_16, 1_q16_16}, {}}, ground);

  BodyId top{};
  for (int i = 0; i < 5; ++i) {
    const auto y = nearest_to<q16_16>(i + 0.5_q16_16);
    top = world.add(Box{{0_q16_16, y}, {0.5_q16_16, 0.5_q16_16}, {}}).value_or(no_object);
  }
  for (int tick = 0; tick < 60; ++tick) world.step();
  if (!world.is_asleep(top)) return 1;

  BodyOptions<q16_16, 2> thrown;
  thrown.density = 4_q16_16;
  thrown.velocity = {20_q16_16, 0_q16_16};
  world.add(Sphere<q16_16, 2>{{-8_q16_16, 3_q16_16}, 0.5_q16_16}, thrown);
  auto saved = snapshot(world);  // bytes

  for (int tick = 0; tick < 120; ++tick) world.step();
  if (world.position(top).y > 4_q16_16) return 1;  // it fell

  const auto played = digest(world);
  if (restore(world, saved) != Restored::yes) return 1;
  for (int tick = 0; tick < 120; ++tick) world.step();
  return digest(world) == played ? 0 : 1;
}
