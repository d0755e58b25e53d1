// SPDX-License-Identifier: MIT
// A ray finds a body of a world, which is then kicked; another body is put on top of the stack.
#include <detent/dynamics/dynamics.hpp>
#include <detent/number/literals.hpp>
using namespace detent;
using namespace detent::literals;

using Bodies = World<q16_16, 2, Sphere, Obb>;
using Vec2 = Vec<q16_16, 2>;

int main() {
  Bodies world;
  const Obb<q16_16, 2> ground{{{}, -1_q16_16}, {50_q16_16, 1_q16_16}, {}};
  world.add(ground, {.motion = BodyMotion::fixed});
  const Obb<q16_16, 2> box{{{}, 0.5_q16_16}, {0.5_q16_16, 0.5_q16_16}, {}};
  const BodyId crate = world.add(box).value_or(no_object);
  const Sphere<q16_16, 2> ball{{5_q16_16, 0.5_q16_16}, 0.5_q16_16};
  const BodyId last = world.add(ball, {.layers = 2}).value_or(no_object);

  SceneOf<Bodies> scene;  // holds what the bodies need: spheres and boxes
  for (int tick = 0; tick < 60; ++tick) world.step();
  follow(scene, world);  // after a step, before queries

  // The ray passes the crate, whose layer does not count, and hits the ball.
  const Ray ray{Vec2{-9_q16_16, 0.5_q16_16}, Direction<q16_16, 2>::along(0)};
  const auto first = scene.nearest_hit(ray), hit = scene.nearest_hit(ray, InLayers{2});
  if (!first || first->id != crate || !hit || hit->id != last) return 1;
  world.apply_impulse(hit->id, {2_q16_16, {}}, hit->point);
  for (int tick = 0; tick < 60; ++tick) world.step();
  if (world.position(last).x < 6_q16_16) return 1;

  // On top of the crate. The scene finds it there once it follows again.
  world.set_position(last, {{}, 1.5_q16_16});
  world.set_velocity(last, {});
  world.set_angular_velocity(last, {});
  follow(scene, world);
  const auto above = scene.all(Sphere<q16_16, 2>{{{}, 1.5_q16_16}, 0.1_q16_16});
  if (above.size() != 1 || above[0].id != last) return 1;

  int fixed = 0;
  world.for_each([&](const BodyInfo& body) { fixed += body.motion == BodyMotion::fixed; });
  return fixed == 1 ? 0 : 1;
}
