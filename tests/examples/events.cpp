// SPDX-License-Identifier: MIT
// Who was caught in this frame, in a world that rolls back together with its events?
#include <detent/scene/events.hpp>
#include <detent/scene/sync_test.hpp>
using namespace detent;

using Vec2 = Vec<q16_16, 2>;

struct Game {
  Scene<q16_16, 2, Sphere> scene;
  OverlapEvents events;
  int catches = 0;
};
template <class F>
void for_each_field(const Game& game, const F& f) {
  f("scene", game.scene);
  f("events", game.events);
  f("catches", game.catches);
}

int main() {
  Game game;
  const auto cat = game.scene.add(Sphere{Vec2{}, q16_16(1)}).value_or(no_object);
  game.scene.add(Sphere{Vec2{q16_16(5), q16_16(0)}, q16_16(1)});
  SyncTest<Game, q16_16> test(3);
  for (int x = 1; x <= 10; ++x) {
    const auto desync = test.step(game, q16_16(1), [&](Game& world, const q16_16& step) {
      world.scene.move(cat, Vec2{step, q16_16(0)});
      world.events.update(world.scene.overlaps());
      world.catches += static_cast<int>(world.events.began().size());
    });
    if (desync) return 1;
  }
  // Caught once, at x = 3, and away again at x = 8.
  return game.catches == 1 && game.events.now().empty() ? 0 : 1;
}
