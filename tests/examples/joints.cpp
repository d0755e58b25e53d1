// SPDX-License-Identifier: MIT
// A crane: a motor lifts an arm to its limit; a rope hangs from its end, with a load that breaks
// off.
#include <cstdio>
#include <detent/dynamics/dynamics.hpp>
#include <detent/number/literals.hpp>
using namespace detent;
using namespace detent::literals;

using S = q16_16;
using Crane = World<S, 2, Sphere, Obb, HingeJoint, DistanceJoint>;  // the joints that it may have

int main() {
  Crane world;
  BodyOptions<S, 2> fixed;
  fixed.motion = BodyMotion::fixed;
  const auto tower = world.add(Obb<S, 2>{{0_q16_16, 3_q16_16}, {0.5_q16_16, 3_q16_16}, {}}, fixed);
  const auto arm = world.add(Obb<S, 2>{{2_q16_16, 6_q16_16}, {2_q16_16, 0.2_q16_16}, {}});
  const auto load = world.add(Sphere<S, 2>{{4_q16_16, 4_q16_16}, 0.5_q16_16});
  if (!tower || !arm || !load) return 1;

  HingeJoint<S, 2> hinge;
  hinge.a = *tower;
  hinge.b = *arm;
  hinge.anchor_a = world.local_point(*tower, {0_q16_16, 6_q16_16});
  hinge.anchor_b = world.local_point(*arm, {0_q16_16, 6_q16_16});
  hinge.has_limits = true;
  hinge.lower = 0_q16_16;
  hinge.upper = 0.5_q16_16;  // radians
  hinge.motor_speed = 1_q16_16;
  hinge.motor_torque = 200_q16_16;
  const auto shoulder = world.add(hinge);

  DistanceJoint<S, 2> rope;
  rope.a = *arm;
  rope.b = *load;
  rope.anchor_a = {2_q16_16, 0_q16_16};  // the end of the arm
  rope.most = 2_q16_16;
  const auto hook = world.add(rope);
  if (!shoulder || !hook) return 1;

  for (int tick = 0; tick < 240; ++tick) world.step();
  const auto lifted = world.position(*load);
  std::printf("lifted to %.3f\n", static_cast<double>(lifted.y));
  if (lifted.y < 5_q16_16) return 1;

  rope.break_force = 1_q16_16;  // the load weighs about 8
  if (!world.change(*hook, rope)) return 1;
  world.step();
  std::printf("%zu broke\n", world.broken_count());
  if (world.broken_count() != 1 || world.broken(0) != *hook || world.contains(*hook)) return 1;

  for (int tick = 0; tick < 60; ++tick) world.step();
  const auto fallen = world.position(*load);
  std::printf("fell to %.3f\n", static_cast<double>(fallen.y));
  return fallen.y < 1_q16_16 ? 0 : 1;
}
