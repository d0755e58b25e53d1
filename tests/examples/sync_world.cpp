// SPDX-License-Identifier: MIT
// A game's own world in a sync test: a scene and velocities. All state is in fields of the world,
// so it is saved, restored and compared, and a desync names the field.
#include <array>

#include <detent/scene/sync_test.hpp>
using namespace detent;

using Vec3 = Vec<q16_16, 3>;

struct Game {
  BoundedScene<Bounded<16>, q16_16, 3, Sphere> scene;
  std::array<Vec3, 2> velocity;
};
template <class F>
void for_each_field(const Game& game, const F& f) {
  f("scene", game.scene);
  f("velocity", game.velocity);
}

int main() {
  Game game{};
  std::array<ObjectId, 2> balls{};
  for (auto& ball : balls) {
    ball = game.scene.add(Sphere{Vec3{}, q16_16(1)}).value_or(no_object);
  }
  int wind = 0;  // a bug: it is neither in the world nor in the inputs
  const auto simulate = [&](Game& world, const q16_16& push) {
    world.velocity[0].x = nearest_to<q16_16>(world.velocity[0].x + push);
    if (push > 0) world.velocity[1].y = q16_16(++wind);
    for (std::size_t i = 0; i < 2; ++i) world.scene.move(balls[i], world.velocity[i]);
  };
  SyncTest<Game, q16_16, 8> test;  // no heap: it stores its eight frames inside itself
  if (test.step(game, q16_16(0), simulate)) return 1;
  const auto desync = test.step(game, q16_16(1), simulate);
  // The ball that the wind moved comes first.
  return desync && desync->frame == 1 && desync->object == balls[1] &&
                 desync->field.view() == "scene object 1:2 (sphere) center.y"
             ? 0
             : 1;
}
