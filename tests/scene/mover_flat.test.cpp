// SPDX-License-Identifier: MIT
//
// Movers in 2D.

#include <algorithm>
#include <cmath>

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

TEMPLATE_TEST_CASE("mover: walks onto and up every slope at every speed in 2D", "", q16_16, q24_8) {
  using S = TestType;
  const auto at = flat_at<S>;
  for (const int degrees : {10, 20, 30, 40, 45, 48, 49}) {
    const auto along = Rotation<S, 2>::from_angle(Angle<S>::turn(degrees, 360)).axis(0);
    const auto up = nearest_to<S>(S(30) * quotient_nearest<S>(along[1], along[0]));
    BoundedScene<Bounded<4>, S, 2, Aabb, Triangle> foot, ramp;
    foot.add(Aabb<S, 2>{at(-9000, -100), at(0, 0)});
    foot.add(Triangle<S, 2>{at(0, 0), at(3000, 0), {S(30), up}});
    ramp.add(
        Triangle<S, 2>{{S(-30), nearest_to<S>(-up)}, {S(30), nearest_to<S>(-up)}, {S(30), up}});
    for (const int steps : {1, 2, 3, 4, 5, 7, 10, 13, 20}) {  // of 1/256, the grid of q24_8
      CAPTURE(degrees, steps);
      const S speed = quotient_nearest<S>(steps, 256);
      for (const auto* const world : {&foot, &ramp}) {
        Mover<S, 2, Sphere> ball{{at(-60, world == &foot ? 60 : 70), Level<S>::number(40)}};
        for (int i = 0; i < 20; ++i) ball.move(*world, at(0, -10));
        const double start = double(ball.shape.center.x);
        const int moves = static_cast<int>(1.6 / double(speed));
        for (int i = 0; i < moves; ++i) {
          ball.move(*world, Vec{speed, Level<S>::number(-5)});
          CHECK(ball.ground.is_grounded);
        }
        const double cosine = double(along[0]);
        CHECK(double(ball.shape.center.x) - start > 1.6 * cosine * cosine - 0.1);
        CHECK(double(ball.shape.center.x) - start < 1.61);
      }
    }
  }
}

TEMPLATE_TEST_CASE("mover: clips long velocities at the planes as stored", "", q16_16, q8_8) {
  using S = TestType;
  for (int degrees = 1; degrees < 90; ++degrees) {
    const auto turn = Rotation<S, 2>::from_angle(Angle<S>::turn(degrees, 360));
    MoveResult<S, 2> slope;
    slope.count = 1;
    slope.touched[0].normal = turn.axis(1);
    for (const int speed : {1, 20, S::bits > 16 ? 20000 : 100}) {
      CAPTURE(degrees, speed);
      const auto left = clip_velocity(Vec<S, 2>{S(speed), S(0)}, slope);
      const double x = double(turn.axis(1)[0]), y = double(turn.axis(1)[1]);
      const double ulp = std::ldexp(1.0, -S::frac);
      const double off = x * speed / (x * x + y * y);
      CHECK(double(left.x) == Approx(speed - off * x).margin(ulp));
      CHECK(double(left.y) == Approx(-off * y).margin(ulp));
    }
  }
}
