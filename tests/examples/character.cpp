// SPDX-License-Identifier: MIT
// A character falls, walks, climbs a step, stops at a wall and rides a lift.
#include <detent/scene/mover.hpp>
using namespace detent;

using Vec3 = Vec<q16_16, 3>;
using Level = BoundedScene<Bounded<4, 1>, q16_16, 3, Aabb>;

Vec3 at(int x, int y, int z) { return {q16_16(x), q16_16(y), q16_16(z)}; }

int main() {
  Level level;
  level.add(Aabb{at(-20, -1, -20), at(20, 0, 20)});
  const ObjectId wall = level.add(Aabb{at(4, 0, -20), at(5, 8, 20)}).value_or(no_object);
  const FrameId lift = level.add_frame({}).value_or(no_frame);
  level.add(Aabb{at(2, -1, 2), {q16_16(4), quotient_nearest<q16_16>(1, 4), q16_16(4)}},
            {.frame = lift});

  Mover<q16_16, 3, Capsule> player{{at(0, 2, 0), at(0, 3, 0), quotient_nearest<q16_16>(1, 2)}};
  const q16_16 step = quotient_nearest<q16_16>(1, 10), gravity = quotient_nearest<q16_16>(1, 100);
  Vec3 velocity;
  const auto walk = [&](int frames, int x, int z) {
    MoveResult<q16_16, 3> result;
    for (int i = 0; i < frames; ++i) {
      velocity = {nearest_to<q16_16>(step * x), velocity.y, nearest_to<q16_16>(step * z)};
      velocity.y -= gravity;
      result = player.move(level, velocity);
      velocity = clip_velocity(velocity, result);
    }
    return result;
  };
  walk(30, 0, 0);
  if (!player.ground.is_grounded) return 1;

  const auto result = walk(40, 1, 0);  // to the wall, and along it
  bool is_at_wall = false;
  for (std::size_t i = 0; i < result.count; ++i) is_at_wall |= result.touched[i].object == wall;
  if (!is_at_wall || velocity.x != 0 || player.shape.a.x >= q16_16(4) - player.shape.radius) {
    return 2;
  }
  walk(30, 0, 1);  // over the edge of the lift
  if (player.ground.frame != lift) return 3;
  for (int i = 1; i <= 60; ++i) {
    level.move_frame(lift, {.translation = {{}, nearest_to<q16_16>(step * i), {}}});
    walk(1, 0, 0);
  }
  return player.ground.is_grounded && player.shape.a.y > 6 ? 0 : 4;
}
