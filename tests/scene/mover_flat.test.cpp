// SPDX-License-Identifier: MIT
//
// Movers in 2D.

#include <algorithm>

#include "scene/mover_level.hpp"

using namespace detent;
using test::Level;

namespace {

/// A point, in hundredths of a unit.
template <Scalar S>
Vec<S, 2> flat_at(int x, int y) {
  return {Level<S>::number(x), Level<S>::number(y)};
}

}  // namespace

TEMPLATE_TEST_CASE("mover: walks, climbs and slides in 2D", "", q24_8, q8_8) {
  using S = TestType;
  const auto at = flat_at<S>;
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

TEST_CASE("mover: climbs steps at every speed in 2D") {
  using S = q16_16;
  const auto at = flat_at<S>;
  BoundedScene<Bounded<4>, S, 2, Aabb> world;
  world.add(Aabb<S, 2>{at(-900, -100), at(9900, 0)});
  world.add(Aabb<S, 2>{at(100, 0), at(9900, 30)});
  for (const int thousandths : {20, 5, 2, 1}) {
    CAPTURE(thousandths);
    const S speed = quotient_nearest<S>(thousandths, 1000);
    Mover<S, 2, Aabb> box{{at(35, 2), at(75, 180)}};
    Mover<S, 2, Sphere> ball{{at(50, 42), Level<S>::number(40)}};
    for (int i = 0; i < 1000; ++i) {
      box.move(world, Vec{speed, Level<S>::number(-1)});
      ball.move(world, Vec{speed, Level<S>::number(-1)});
    }
    CHECK(double(box.shape.min.y) > 0.3);
    CHECK(double(ball.shape.center.y) > 0.7);
    // It does not run ahead, except by the skin with which it steps up.
    const double asked = thousandths;
    CHECK(double(ball.shape.center.x) > 0.5 + asked - 0.1);
    CHECK(double(ball.shape.center.x) < 0.5 + asked + 0.1);
  }
}

TEST_CASE("mover: no kerb stops a fast character in 2D") {
  using S = q16_16;
  const auto at = flat_at<S>;
  // The ground behind the kerb is level, higher, lower, or an abyss.
  for (const int behind : {0, 5, -5, -20, -2000}) {
    BoundedScene<Bounded<4>, S, 2, Aabb> world;
    world.add(Aabb<S, 2>{at(-900, -9000), at(110, 0)});
    world.add(Aabb<S, 2>{at(100, 0), at(110, 20)});
    world.add(Aabb<S, 2>{at(110, -9000), at(20000, behind)});
    for (const int speed : {10, 30, 50, 70, 100}) {
      CAPTURE(behind, speed);
      Mover<S, 2, Sphere> ball{{at(0, 27), Level<S>::number(25)}};
      for (int i = 0; i < 100; ++i) {
        ball.move(world, at(speed, -10));
        CHECK_FALSE(world.any(ball.shape));
      }
      CHECK(double(ball.shape.center.x) > speed - 1);
    }
  }
}
