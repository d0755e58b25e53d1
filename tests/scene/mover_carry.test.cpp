// SPDX-License-Identifier: MIT
//
// Platforms that tilt, turn and have parts of their own, and those who ride them.

#include "detent/number/literals.hpp"
#include "detent/scene/mover.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

using namespace detent::literals;

using S = q16_16;
using Vec2 = Vec<S, 2>;
using Vec3 = Vec<S, 3>;
using Platforms = BoundedScene<Bounded<4, 4>, S, 2, Obb>;

/// A box 0.8 wide that stands on a platform whose top is at 0.1.
Mover<S, 2, Aabb> rider_on(Platforms& world) {
  Mover<S, 2, Aabb> rider{{Vec2{-0.4_q16_16, 0.11_q16_16}, Vec2{0.4_q16_16, 1.6_q16_16}}};
  rider.move(world, Vec2{0_q16_16, -0.05_q16_16});
  REQUIRE(rider.ground.is_grounded);
  return rider;
}

TEST_CASE("mover: a platform that tilts as it moves carries its rider") {
  // The platform moves so far that the rider would not touch it any more where it was.
  for (const S speed : {2.5_q16_16, -0.5_q16_16}) {
    for (const int tenths : {0, 5, 15}) {
      CAPTURE(double(speed), tenths);
      Platforms world;
      const auto frame = world.add_frame({}).value_or(no_frame);
      world.add(Obb<S, 2>{{}, Vec2{3_q16_16, 0.1_q16_16}, {}}, {.frame = frame});
      auto rider = rider_on(world);
      for (int i = 1; i <= 10; ++i) {
        const auto turn = Angle<S>::turn(i % 2 == 1 ? tenths : 0, 3600);
        world.move_frame(frame, {.translation = Vec2{0_q16_16, nearest_to<S>(speed * i)},
                                 .rotation = Rotation<S, 2>::from_angle(turn)});
        const auto result = rider.move(world, Vec2{0_q16_16, -0.05_q16_16});
        CHECK(abs(result.carried.y - speed) < 0.05_q16_16);
        CHECK(rider.ground.is_grounded);
        CHECK_FALSE(result.is_stuck);
        CHECK_FALSE(world.any(rider.shape));
        const auto height = rider.shape.min.y - speed * i;
        CHECK(height > 0.1_q16_16);
        CHECK(height < 0.2_q16_16);
      }
    }
  }
}

TEST_CASE("mover: a wall in a frame below that of the platform moves with the rider") {
  for (const bool is_child : {false, true}) {
    CAPTURE(is_child);
    Platforms world;
    const auto train = world.add_frame({}).value_or(no_frame);
    const auto part = world.add_frame({}, train).value_or(no_frame);
    world.add(Obb<S, 2>{{}, Vec2{6_q16_16, 0.1_q16_16}, {}}, {.frame = train});
    world.add(Obb<S, 2>{Vec2{-0.8_q16_16, 1_q16_16}, Vec2{0.1_q16_16, 1_q16_16}, {}},
              {.frame = is_child ? part : train});
    auto rider = rider_on(world);
    for (int i = 1; i <= 3; ++i) {
      world.move_frame(train, {.translation = Vec2{S(2 * i), {}}});
      rider.move(world, Vec2{0_q16_16, -0.05_q16_16});
      CHECK(abs(rider.shape.min.x + 0.4_q16_16 - S(2 * i)) < 0.001_q16_16);
    }
  }
}

TEST_CASE("mover: a room that is turned over keeps who is in it") {
  for (const int degrees : {10, 90, 120, 180}) {
    CAPTURE(degrees);
    Platforms world;
    const auto room = world.add_frame({}).value_or(no_frame);
    const Vec2 flat{3.2_q16_16, 0.1_q16_16}, upright{0.1_q16_16, 3.2_q16_16};
    for (const int side : {-3, 3}) {
      world.add(Obb<S, 2>{Vec2{{}, S(side)}, flat, {}}, {.frame = room});
      world.add(Obb<S, 2>{Vec2{S(side), {}}, upright, {}}, {.frame = room});
    }
    Mover<S, 2, Aabb> rider{{Vec2{0.2_q16_16, -2.88_q16_16}, Vec2{1_q16_16, -1.4_q16_16}}};
    const Vec2 down{{}, -0.05_q16_16};
    rider.move(world, down);
    for (int i = 1; i <= 100; ++i) {
      const auto turn = Angle<S>::turn(i * degrees % 360, 360);
      world.move_frame(room, {.rotation = Rotation<S, 2>::from_angle(turn)});
      const auto result = rider.move(world, down);
      CHECK((result.is_stuck || !world.any(rider.shape)));
      const auto middle = half(rider.shape.min + rider.shape.max);
      CHECK(squared_length(middle) < S(18));  // in the room
    }
  }
}

TEST_CASE("mover: a box turns about its middle") {
  for (const int distance : {0, 3}) {
    CAPTURE(distance);
    BoundedScene<Bounded<2, 2>, S, 3, Obb> world;
    const auto frame = world.add_frame({}).value_or(no_frame);
    const Vec3 half_size{5_q16_16, 0.5_q16_16, 5_q16_16};
    world.add(Obb<S, 3>{Vec3{{}, -0.5_q16_16, {}}, half_size, {}}, {.frame = frame});
    const S near = nearest_to<S>(S(distance) - 0.4_q16_16);
    const S far = nearest_to<S>(S(distance) + 0.4_q16_16);
    Mover<S, 3, Aabb> rider{
        {Vec3{near, 0.02_q16_16, -0.4_q16_16}, Vec3{far, 1.8_q16_16, 0.4_q16_16}}};
    const Vec3 down{{}, -0.05_q16_16, {}};
    rider.move(world, down);
    for (int i = 1; i <= 180; ++i) {
      const auto turn =
          Rotation<S, 3>::from_axis_angle(Direction<S, 3>::along(1), Angle<S>::turn(i, 360));
      world.move_frame(frame, {.rotation = turn});
      rider.move(world, down);
    }
    const auto middle = half(rider.shape.min + rider.shape.max);
    CHECK(abs(middle.x + S(distance)) < 0.01_q16_16);
    CHECK(abs(middle.z) < 0.01_q16_16);
  }
}

}  // namespace
}  // namespace detent::test
