// SPDX-License-Identifier: MIT
// A character among the rigid bodies of a world: it rides a ferry, pushes a crate, and a ball that
// falls on it bounces off.
#include <detent/dynamics/dynamics.hpp>
#include <detent/number/literals.hpp>
#include <detent/scene/mover.hpp>
using namespace detent;
using namespace detent::literals;

using Vec3 = Vec<q16_16, 3>;
using Bodies = World<q16_16, 3, Sphere, Capsule, Obb>;

struct Game {
  Bodies world;  // 60 ticks a second
  Mover<q16_16, 3, Capsule> player{
      {{-3_q16_16, 0.6_q16_16, {}}, {-3_q16_16, 1.6_q16_16, {}}, 0.5_q16_16}};
  Vec3 velocity;          // per tick, relative to the ground
  BodyId shadow{};        // a kinematic capsule, with which other bodies collide
  SceneOf<Bodies> scene;  // follows the world, so it is not part of the state
};

BodyId add_box(Bodies& world, const Vec3& center, const Vec3& half_size, BodyMotion motion) {
  return world.add(Obb<q16_16, 3>{center, half_size, {}}, {.motion = motion}).value_or(no_object);
}

void tick(Game& game, const q16_16& walk) {
  Bodies& world = game.world;
  auto& player = game.player;
  world.step();
  follow(game.scene, world);

  game.velocity.x = walk;
  game.velocity.y -= 0.003_q16_16;
  Vec3 motion = game.velocity;
  if (player.ground
          .is_grounded) {  // what it stands on carries it; not up and down, which is a jump
    const Vec3 ground = world.velocity(player.ground.object);
    motion.x += quotient_nearest<q16_16>(ground.x, 60);
    motion.z += quotient_nearest<q16_16>(ground.z, 60);
  }
  const auto result = player.move(
      game.scene, motion, {}, [&](const ObjectInfo& object) { return object.id != game.shadow; });
  game.velocity.y = min(clip_velocity(game.velocity, result).y, 0_q16_16);

  for (std::size_t i = 0; i < result.count; ++i) {  // it pushes what it touches
    const auto& touch = result.touched[i];
    world.apply_impulse(touch.object, nearest_to<q16_16>(touch.normal.vec() * -0.2_q16_16),
                        touch.point);
  }
  const Vec3 center = nearest_to<q16_16>(half(player.shape.a + player.shape.b));
  world.set_velocity(game.shadow, nearest_to<q16_16>((center - world.position(game.shadow)) * 60));
}

int main() {
  Game game;
  Bodies& world = game.world;
  const Vec3 bank{4_q16_16, 1_q16_16, 4_q16_16};
  add_box(world, {-6_q16_16, -1_q16_16, {}}, bank, BodyMotion::fixed);
  add_box(world, {14_q16_16, -1_q16_16, {}}, bank, BodyMotion::fixed);
  const BodyId ferry = add_box(world, {0_q16_16, -1_q16_16, {}}, {2_q16_16, 1_q16_16, 2_q16_16},
                               BodyMotion::kinematic);
  const BodyId crate = add_box(world, {12_q16_16, 0.5_q16_16, {}},
                               {0.5_q16_16, 0.5_q16_16, 0.5_q16_16}, BodyMotion::dynamic);
  game.shadow = world.add(game.player.shape, {.motion = BodyMotion::kinematic}).value_or(no_object);

  for (int i = 0; i < 60; ++i) tick(game, 0.05_q16_16);  // onto the ferry
  if (game.player.ground.object != ferry) return 1;
  world.set_velocity(ferry, {2_q16_16, {}, {}});
  for (int i = 0; i < 240; ++i) tick(game, {});  // across
  world.set_velocity(ferry, {});
  if (game.player.ground.object != ferry || game.player.shape.a.x < 7.9_q16_16) return 2;
  for (int i = 0; i < 120; ++i) tick(game, 0.05_q16_16);  // ashore, and against the crate
  if (world.position(crate).x < 12.5_q16_16) return 3;

  const Vec3 above{game.player.shape.b.x, 4_q16_16, {}};
  const BodyId ball = world.add(Sphere<q16_16, 3>{above, 0.25_q16_16}).value_or(no_object);
  q16_16 lowest = 4_q16_16;
  for (int i = 0; i < 60; ++i) {
    tick(game, {});
    lowest = min(lowest, world.position(ball).y);
  }
  return lowest > 2_q16_16 ? 0 : 4;
}
