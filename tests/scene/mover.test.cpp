// SPDX-License-Identifier: MIT
#include "detent/scene/mover.hpp"

#include <algorithm>
#include <type_traits>

#include "detent/scene/sync_test.hpp"
#include "scene/mover_level.hpp"

using namespace detent;
using test::Level;

namespace {

// The shape alone names the type, in every compiler.
static_assert(std::is_same_v<decltype(Mover{Capsule<q16_16, 2>{}}), Mover<q16_16, 2, Capsule>>);

// From an ULP to the skin and its rounding errors.
constexpr double skin = 1.0 / 64 + 1e-3;

}  // namespace

TEMPLATE_TEST_CASE("mover: falls onto a floor, stays a skin above it, and walks on it", "", q16_16,
                   float) {
  Level<TestType> level;
  const auto floor = level.floor();
  auto walker = level.person(0, 100, 0);
  for (int i = 0; i < 20; ++i) CHECK_FALSE((level.walk(walker, 1, 0), walker.ground.is_grounded));
  level.walk(walker, 20, 0);
  CHECK(walker.ground.is_grounded);
  CHECK(walker.ground.object == floor);
  CHECK(double(walker.ground.normal[1]) == 1);
  CHECK(level.feet(walker) > 0);
  CHECK(level.feet(walker) < skin);
  const double height = level.feet(walker);
  const auto result = level.walk(walker, 50, 10);
  CHECK(level.x(walker) == Approx(5).margin(0.01));
  CHECK(level.feet(walker) == Approx(height).margin(1e-3));
  CHECK(result.count == 1);
  CHECK(result.touched[0].object == floor);
  CHECK(result.pushed == Vec<TestType, 3>{});
}

TEMPLATE_TEST_CASE("mover: walks up a slope of 30 degrees but not one of 60", "", q16_16, float) {
  for (const int degrees : {30, 60}) {
    Level<TestType> level;
    level.floor();
    level.slope(degrees);
    auto walker = level.person(-200, 0, 0);
    level.walk(walker, 100, 5);
    CAPTURE(degrees);
    if (degrees == 30) {
      CHECK(level.x(walker) > 1.5);
      CHECK(level.feet(walker) > 0.8);
      CHECK(walker.ground.is_grounded);
      // It stands still on the slope.
      const auto before = walker.shape;
      level.walk(walker, 50, 0);
      CHECK(level.x(walker) == Approx(double(before.a.x)).margin(0.01));
      // It also follows the slope down.
      level.walk(walker, 10, -5);
      CHECK(walker.ground.is_grounded);
      CHECK(level.x(walker) < double(before.a.x) - 0.4);
    } else {
      CHECK(level.feet(walker) < skin);
      CHECK(level.x(walker) < 0);
      CHECK(walker.ground.is_grounded);
    }
  }
}

// The game sets the horizontal velocity in every frame: see docs/motion.md.
TEMPLATE_TEST_CASE("mover: climbs a slope of 60 degrees unless the rise of its velocity is capped",
                   "", q16_16, float) {
  using S = TestType;
  for (const bool is_capped : {true, false}) {
    Level<S> level;
    level.floor();
    level.slope(60);
    auto walker = level.person(-200, 0, 0);
    Vec<S, 3> velocity{};
    for (int frame = 0; frame < 150; ++frame) {
      velocity.x = level.number(5);
      velocity.y -= level.number(1);
      const S rise = max(velocity.y, S(0));
      const auto result = walker.move(level.world, velocity);
      velocity = clip_velocity(velocity, result);
      if (is_capped) velocity.y = min(velocity.y, rise);
    }
    CAPTURE(is_capped);
    CHECK((level.feet(walker) < skin) == is_capped);
    CHECK(walker.ground.is_grounded == is_capped);
    CHECK((level.x(walker) < 0) == is_capped);
  }
}

TEMPLATE_TEST_CASE("mover: slides down a slope of 60 degrees", "", q16_16, float) {
  Level<TestType> level;
  level.floor();
  level.slope(60);
  auto walker = level.person(200, 420, 0);
  level.walk(walker, 50, 0);
  CHECK_FALSE(walker.ground.is_grounded);
  level.walk(walker, 300, 0);
  CHECK(walker.ground.is_grounded);
  CHECK(level.feet(walker) < skin);
  CHECK(level.x(walker) < 0);
}

TEMPLATE_TEST_CASE("mover: climbs stairs and walks down them", "", q16_16, float) {
  Level<TestType> level;
  level.floor();
  for (int i = 0; i < 10; ++i) {
    level.box(level.at(100 + 40 * i, 0, -200), level.at(1000, 25 * (i + 1), 200));
  }
  auto walker = level.person(0, 2, 0);
  level.walk(walker, 2, 0);
  double highest = 0;
  for (int i = 0; i < 140; ++i) {
    level.walk(walker, 1, 5);
    CHECK(walker.ground.is_grounded);
    CHECK(level.feet(walker) >= highest - 0.01);
    highest = level.feet(walker);
  }
  CHECK(highest == Approx(2.5).margin(0.05));
  CHECK(level.x(walker) > 5);
  for (int i = 0; i < 140; ++i) {
    level.walk(walker, 1, -5);
    CHECK(walker.ground.is_grounded);
  }
  CHECK(level.feet(walker) < skin);
  CHECK(level.x(walker) < 0.7);
}

TEMPLATE_TEST_CASE("mover: a step higher than the limit is a wall", "", q16_16, float) {
  Level<TestType> level;
  level.floor();
  level.box(level.at(100, 0, -500), level.at(500, 45, 500));
  auto walker = level.person(0, 2, 0);
  level.walk(walker, 60, 5);
  CHECK(level.feet(walker) < skin);
  CHECK(level.x(walker) == Approx(0.6).margin(0.02));
  level.settings.step_height = level.number(50);
  level.walk(walker, 60, 5);
  CHECK(level.feet(walker) == Approx(0.45 + 1.0 / 64).margin(0.01));
}

TEMPLATE_TEST_CASE("mover: climbs slowly over an edge onto any slope that is not too steep", "",
                   q16_16, float) {
  using S = TestType;
  for (const int most : {35, 50, 70}) {
    for (const int degrees : {30, most - 6, most - 1, most + 2}) {
      Level<S> level;
      const auto floor = level.floor();
      const auto slope = level.ledge(degrees, 30);
      level.settings.max_slope = Angle<S>::turn(most, 360);
      auto walker = level.person(-60, 2, 0);
      level.walk(walker, 60, 1);
      CAPTURE(most, degrees);
      CHECK(walker.ground.is_grounded);
      CHECK(walker.ground.object == (degrees < most ? slope : floor));
    }
  }
}

TEMPLATE_TEST_CASE("mover: slides along a wall at its velocity's component along the wall", "",
                   q16_16, float) {
  Level<TestType> level;
  level.floor();
  level.box(level.at(100, 0, -2000), level.at(200, 300, 2000));
  auto walker = level.person(0, 2, 0);
  const auto result = level.walk(walker, 100, 5, 5);
  CHECK(level.x(walker) == Approx(0.6 - 1.0 / 64).margin(1e-3));
  CHECK(level.z(walker) == Approx(5).margin(0.02));
  CHECK(result.count == 2);
  const auto velocity = clip_velocity(level.at(500, -100, 300), result);
  CHECK(double(velocity.x) == Approx(0).margin(1e-3));
  CHECK(double(velocity.y) == Approx(0).margin(1e-3));
  CHECK(double(velocity.z) == Approx(3).margin(1e-3));
}

TEMPLATE_TEST_CASE("mover: stops in a corner of three planes, and leaves it", "", q16_16, float) {
  Level<TestType> level;
  level.floor();
  level.box(level.at(100, 0, -2000), level.at(200, 300, 2000));
  level.box(level.at(-2000, 0, 100), level.at(2000, 300, 200));
  auto walker = level.person(0, 2, 0);
  level.walk(walker, 100, 5, 3);
  CHECK(level.x(walker) == Approx(0.6 - 1.0 / 64).margin(1e-3));
  CHECK(level.z(walker) == Approx(0.6 - 1.0 / 64).margin(1e-3));
  const auto before = walker.shape;
  const auto result = level.walk(walker, 100, 5, 3);
  CHECK(double(walker.shape.a.x) == Approx(double(before.a.x)).margin(1e-3));
  CHECK(result.count == 3);
  level.walk(walker, 20, -5, 3);
  CHECK(level.x(walker) == Approx(-0.4).margin(0.03));
}

TEMPLATE_TEST_CASE("mover: follows the crease of two slanted walls", "", q16_16, float) {
  // A valley along z between two walls of 60 degrees.
  Level<TestType> level;
  const auto wall = [&](int degrees) {
    const auto turn = Rotation<TestType, 3>::from_axis_angle(Direction<TestType, 3>::along(2),
                                                             Angle<TestType>::turn(degrees, 360));
    const auto depth = level.number(200);
    level.world.add(Obb<TestType, 3>{nearest_to<TestType>(turn.axis(1) * -depth),
                                     level.at(1000, 200, 3000), turn});
  };
  wall(60);
  wall(-60);
  auto walker = level.person(0, 200, 0);
  level.walk(walker, 100, 0);
  const double rest = level.feet(walker);
  level.walk(walker, 100, 3, 10);
  CHECK(level.z(walker) == Approx(10).margin(0.5));
  CHECK(level.feet(walker) == Approx(rest).margin(0.05));
}

TEMPLATE_TEST_CASE("mover: does not pass under a low ceiling", "", q16_16, float) {
  Level<TestType> level;
  level.floor();
  level.box(level.at(100, 170, -500), level.at(500, 300, 500));
  auto walker = level.person(0, 2, 0);
  level.walk(walker, 60, 5);
  CHECK(level.x(walker) < 1);
  Level<TestType> higher;
  higher.floor();
  higher.box(level.at(100, 185, -500), level.at(500, 300, 500));
  walker = level.person(0, 2, 0);
  higher.walk(walker, 60, 5);
  CHECK(level.x(walker) == Approx(3).margin(0.02));
}

TEMPLATE_TEST_CASE("mover: rides a lift and a rotating disc", "", q16_16, float) {
  using S = TestType;
  Level<S> level;
  const auto lift = level.world.add_frame({}).value_or(no_frame);
  level.box(level.at(-300, -20, -300), level.at(300, 0, 300), {.frame = lift});
  auto walker = level.person(100, 5, 0);
  level.walk(walker, 4, 0);
  REQUIRE(walker.ground.is_grounded);
  CHECK(walker.ground.frame == lift);
  for (int i = 1; i <= 60; ++i) {
    level.world.move_frame(lift, {.translation = level.at(3 * i, 5 * i, 0)});
    const auto result = level.walk(walker, 1, 0);
    CHECK(double(result.carried.y) == Approx(0.05).margin(1e-3));
    CHECK(walker.ground.is_grounded);
  }
  CHECK(level.feet(walker) == Approx(3 + 1.0 / 64).margin(2e-3));
  CHECK(level.x(walker) == Approx(1 + 1.8).margin(2e-3));
  for (int i = 59; i >= 0; --i) {
    level.world.move_frame(lift, {.translation = level.at(3 * i, 5 * i, 0)});
    level.walk(walker, 1, 0);
    CHECK(walker.ground.is_grounded);
  }
  CHECK(level.feet(walker) == Approx(1.0 / 64).margin(2e-3));
  // A quarter turn takes it from the x axis to the negative z axis.
  const auto up = Direction<S, 3>::along(1);
  for (int i = 1; i <= 90; ++i) {
    const auto turn = Rotation<S, 3>::from_axis_angle(up, Angle<S>::turn(i, 360));
    level.world.move_frame(lift, {.rotation = turn});
    level.walk(walker, 1, 0);
  }
  CHECK(level.x(walker) == Approx(0).margin(0.01));
  CHECK(level.z(walker) == Approx(-1).margin(0.01));
  CHECK(walker.ground.is_grounded);
}

TEMPLATE_TEST_CASE("mover: jumps, hits a ceiling and lands", "", q16_16, float) {
  Level<TestType> level;
  level.floor();
  level.box(level.at(-500, 250, -500), level.at(500, 300, 500));
  auto walker = level.person(0, 2, 0);
  level.walk(walker, 4, 0);
  REQUIRE(walker.ground.is_grounded);
  int speed = 12;
  bool met = false;
  for (int i = 0; i < 12; ++i, --speed) {
    const auto result = walker.move(level.world, level.at(2, speed, 0), level.settings);
    met = met || (result.count > 0 && result.touched[0].normal[1] < 0);
    CHECK_FALSE(walker.ground.is_grounded);
  }
  CHECK(met);
  CHECK(level.feet(walker) == Approx(0.7 - 1.0 / 64).margin(2e-3));
  level.walk(walker, 40, 2);
  CHECK(walker.ground.is_grounded);
  CHECK(level.feet(walker) < skin);
}

TEMPLATE_TEST_CASE("mover: is pushed out of what it overlaps at the start", "", q16_16, float) {
  Level<TestType> level;
  level.floor();
  level.box(level.at(20, 0, -500), level.at(500, 300, 500));
  auto walker = level.person(0, -10, 0);
  const auto result = walker.move(level.world, level.at(0, 0, 0), level.settings);
  CHECK_FALSE(result.is_stuck);
  CHECK(result.pushed != Vec<TestType, 3>{});
  CHECK(level.x(walker) == Approx(-0.2 - 1.0 / 64).margin(0.01));
  CHECK(level.feet(walker) == Approx(1.0 / 64).margin(0.01));
  CHECK_FALSE(level.world.any(walker.shape));
}

TEMPLATE_TEST_CASE("mover: a filter selects what it collides with", "", q16_16, float) {
  Level<TestType> level;
  level.floor();
  const auto door = level.box(level.at(100, 0, -500), level.at(200, 300, 500), {.layers = 2});
  auto walker = level.person(0, 2, 0);
  level.walk(walker, 60, 5);
  CHECK(level.x(walker) < 1);
  for (int i = 0; i < 60; ++i) walker.move(level.world, level.at(5, -4, 0), {}, InLayers{1});
  CHECK(level.x(walker) > 3);
  CHECK(walker.ground.is_grounded);
  const auto is_not_door = [&](const ObjectInfo& object) { return object.id != door; };
  for (int i = 0; i < 60; ++i) walker.move(level.world, level.at(-5, -4, 0), {}, is_not_door);
  CHECK(level.x(walker) < 1);
}

TEST_CASE("mover: its state has a digest and is compared field by field") {
  using S = q16_16;
  Level<S> level;
  level.floor();
  auto walker = level.person(0, 2, 0), other = walker;
  level.walk(walker, 4, 0);
  CHECK(digest(walker) != digest(other));
  int fields = 0;
  for_each_field(walker, [&](const detail::PartName&, const auto&) { ++fields; });
  CHECK(fields == 2);
  static_assert(RollbackWorld<Mover<S, 3, Capsule>>);
  level.walk(other, 4, 0);
  CHECK(digest(walker) == digest(other));
}
