// SPDX-License-Identifier: MIT
//
// Movers in 2D.

#include <algorithm>

#include "scene/mover_level.hpp"

using namespace detent;
using test::Level;

TEMPLATE_TEST_CASE("mover: walks, climbs and slides in 2D", "", q24_8, q8_8) {
  using S = TestType;
  using V = Vec<S, 2>;
  const auto at = [](int x, int y) { return V{Level<S>::number(x), Level<S>::number(y)}; };
  BoundedScene<Bounded<8>, S, 2, Aabb> world;
  world.add(Aabb<S, 2>{at(-2000, -100), at(2000, 0)});
  world.add(Aabb<S, 2>{at(300, 0), at(500, 30)});
  world.add(Aabb<S, 2>{at(800, 0), at(900, 500)});
  Mover<S, 2, Capsule> walker{{at(0, 60), at(0, 160), Level<S>::number(40)}};
  MoverSettings<S, 2> settings;
  settings.step_height = Level<S>::number(50);
  double highest = 0;
  for (int i = 0; i < 100; ++i) {
    walker.move(world, at(10, -10), settings);
    highest = std::max(highest, double(walker.shape.a.y));
    CHECK_FALSE(world.any(walker.shape));
  }
  const double wide = double(std::max(settings.skin, Level<S>::number(0))) + 0.15;
  CHECK(highest > 0.7);
  CHECK(highest < 0.7 + wide);
  CHECK(double(walker.shape.a.y) > 0.4);
  CHECK(double(walker.shape.a.y) < 0.4 + wide);
  CHECK(double(walker.shape.a.x) < 7.6);
  CHECK(double(walker.shape.a.x) > 7.6 - wide);
  CHECK(walker.ground.is_grounded);
}
