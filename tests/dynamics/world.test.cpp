// SPDX-License-Identifier: MIT
#include "detent/dynamics/world.hpp"

#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

#include "detent/dynamics/snapshot.hpp"
#include "dynamics/stage.hpp"
#include "oracle/space.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

template <Scalar S, int N>
using BallWorld = World<S, N, Sphere>;

TEMPLATE_TEST_CASE("world: a column of balls comes to rest and sleeps, and then nothing moves", "",
                   DETENT_EVERY_SCALAR) {
  using S = TestType;
  const auto column = [](auto world) {
    constexpr int N = decltype(world)::dimension;
    add_round_ground(world);
    std::vector<BodyId> ids;
    for (int i = 0; i < 5; ++i) ids.push_back(add_ball(world, 0, 1.1 + 2.1 * i));
    for (int t = 0; t < 300; ++t) world.step();
    for (const auto& id : ids) {
      REQUIRE(world.is_asleep(id));
      REQUIRE(world.velocity(id) == Vec<S, N>());
    }
    const double top = static_cast<double>(world.position(ids.back()).y);
    CHECK(top > 8.95);
    CHECK(top < 9.0);
    const auto before = digest(world);
    for (int t = 0; t < 1000; ++t) world.step();
    CHECK(digest(world) == before);
    return top;
  };
  const double flat = column(BallWorld<S, 2>());
  const double solid = column(BallWorld<S, 3>());
  CHECK(std::fabs(flat - solid) < 0.01);
}

TEST_CASE("world: every scalar computes the same integers") {
  // In q24_8 with lengths 256 times as large, a world has the raw numbers of one in q16_16.
  const auto raw = []<class S>(S, double scale) {
    WorldSettings<S, 2> settings;
    settings.gravity = {S(0), num<S>(-10 * scale)};
    settings.margin = num<S>(5 / 256.0 * scale);
    settings.hold_distance = num<S>(26 / 256.0 * scale);
    settings.push_speed = num<S>(3 * scale);
    settings.bounce_threshold = num<S>(scale);
    settings.sleep_speed = S(0);  // it also applies to spins
    World<S, 2, Sphere> world(settings);
    BodyOptions<S, 2> fixed;
    fixed.motion = BodyMotion::fixed;
    BodyOptions<S, 2> loose;
    fixed.friction = loose.friction = num<S>(0.5);  // exact in both scalars
    world.add(Sphere<S, 2>{{S(0), num<S>(-50 * scale)}, num<S>(50 * scale)}, fixed);
    for (int i = 0; i < 8; ++i) {
      world.add(Sphere<S, 2>{{num<S>(0.25 * (i % 3) * scale), num<S>((1 + 1.5 * i) * scale)},
                             num<S>(0.5 * scale)},
                loose);
    }
    std::vector<long long> result;
    for (int t = 0; t < 200; ++t) world.step();
    const auto& bodies = detail::WorldAccess::bodies(world);
    for (std::size_t i = 1; i < bodies.size(); ++i) {
      for (int k = 0; k < 2; ++k) {
        result.push_back(bodies[i].state.place[k].raw());
        result.push_back(bodies[i].state.velocity[k].raw());
      }
      result.push_back(bodies[i].state.spin[0].raw());
    }
    return result;
  };
  CHECK(raw(q16_16(), 1) == raw(q24_8(), 256));
  CHECK(raw(q16_16(), 1) == raw(q14_16(), 1));
}

TEST_CASE("world: events report when bodies begin and cease to touch") {
  BallWorld<q16_16, 2> world;
  add_round_ground(world);
  BodyOptions<q16_16, 2> bouncy;
  bouncy.restitution = q16_16(1);
  const auto ball = add_ball(world, 0, 3, bouncy);
  int begun = 0, ended = 0;
  for (int t = 0; t < 100; ++t) {
    world.step();
    for (std::size_t i = 0; i < world.event_count(); ++i) {
      CHECK(world.event(i).b == ball);
      (world.event(i).begins ? begun : ended) += 1;
    }
  }
  CHECK(begun == 1);
  CHECK(ended == 1);
  // It lost next to no energy: sqrt(2 g 2) upwards at the ground.
  CHECK(static_cast<double>(world.position(ball).y) > 2.1);
}

TEST_CASE("world: bodies collide only if both layer masks agree") {
  BallWorld<q16_16, 2> world;
  add_round_ground(world);
  BodyOptions<q16_16, 2> ghost;
  ghost.collides_with = 2;
  const auto falls = add_ball(world, 0, 3, ghost);
  BodyOptions<q16_16, 2> other;
  other.layers = 4;
  const auto rests = add_ball(world, 5, 3, other);
  for (int t = 0; t < 120; ++t) world.step();
  CHECK(world.position(falls).y < -10);
  CHECK(world.position(rests).y > 0);
}

TEST_CASE("world: rates out of the domain are clamped") {
  const auto rates = [](int ticks, int substeps) {
    BallWorld<q16_16, 3> world({.ticks_per_second = ticks, .substeps = substeps});
    add_ball(world, 0, 0);
    world.step();
    const auto& settings = world.settings();
    return std::pair{settings.ticks_per_second, settings.substeps};
  };
  CHECK(rates(60, 4) == std::pair{60, 4});
  CHECK(rates(60000, 9) == std::pair{32767, 1});
  CHECK(rates(100, 2'000'000'000) == std::pair{100, 327});
  CHECK(rates(0, 0) == std::pair{1, 1});
  CHECK(rates(-60, -4) == std::pair{1, 1});
}

TEST_CASE("world: a skipped step would change nothing") {
  BallWorld<q16_16, 2> world;
  add_round_ground(world);
  const auto low = add_ball(world, 0, 1);
  add_ball(world, 0, 3);
  BodyOptions<q16_16, 2> kinematic;
  kinematic.motion = BodyMotion::kinematic;
  const auto lift = add_ball(world, 9, 9, kinematic);
  auto other = world;
  for (int t = 0; t < 400; ++t) {
    if (t == 200 || t == 320) {
      for (auto* each : {&world, &other}) {
        each->set_velocity(t == 200 ? low : lift, {q16_16(-1), q16_16(t == 200 ? 2 : -3)});
      }
    }
    other.set_velocity(no_object, {});  // as if something might have changed
    world.step();
    other.step();
    REQUIRE(digest(world) == digest(other));
    REQUIRE(world.event_count() == other.event_count());
  }
}

TEST_CASE("world: a sleeping body wakes when it is hit, pushed or loses its support") {
  BallWorld<q16_16, 2> world;
  add_round_ground(world);
  const auto low = add_ball(world, 0, 1);
  const auto high = add_ball(world, 0, 3);
  for (int t = 0; t < 120; ++t) world.step();
  REQUIRE(world.is_asleep(high));
  SECTION("hit") {
    BodyOptions<q16_16, 2> fast;
    fast.velocity = {q16_16(0), q16_16(-20)};
    add_ball(world, 0, 8, fast);
    for (int t = 0; t < 20; ++t) world.step();
    CHECK(!world.is_asleep(low));
  }
  SECTION("pushed") {
    world.set_velocity(high, {q16_16(0), q16_16(3)});
    CHECK(!world.is_asleep(high));
    world.step();
    CHECK(!world.is_asleep(low));
    CHECK(world.position(high).y > 3);
  }
  SECTION("without support") {
    REQUIRE(world.remove(low));
    CHECK(!world.contains(low));
    for (int t = 0; t < 120; ++t) world.step();
    CHECK(world.position(high).y < q16_16(2));
  }
}

TEST_CASE("world: a kinematic body pushes and cannot be stopped") {
  BallWorld<q16_16, 2> world;
  add_round_ground(world);
  const auto ball = add_ball(world, 0, 1);
  BodyOptions<q16_16, 2> driven;
  driven.motion = BodyMotion::kinematic;
  driven.velocity = {q16_16(2), q16_16(0)};
  const auto pusher = add_ball(world, -4, 1, driven);
  for (int t = 0; t < 120; ++t) world.step();
  CHECK(world.position(pusher).x == q16_16(0));
  CHECK(static_cast<double>(world.position(ball).x) > 1.9);
}

TEST_CASE("world: the mass is density times area, and 0 for fixed and kinematic bodies") {
  World<q16_16, 2, Sphere, Obb> world;
  const Obb<q16_16, 2> box{{}, {q16_16(1), q16_16(2)}, {}};
  const auto heavy = *world.add(box, {.density = q16_16(3)});
  CHECK(world.mass(heavy) == 24);
  CHECK(world.mass(*world.add(box, {.motion = BodyMotion::kinematic})) == 0);
  const Obb<q16_16, 2> huge{{}, {q16_16(30000), q16_16(30000)}, {}};
  CHECK(world.mass(*world.add(huge)) == q16_16::max());
  REQUIRE(world.remove(heavy));
  CHECK(world.mass(heavy) == 0);
}

TEMPLATE_TEST_CASE("world: a moved-from world is like new", "",
                   (World<q16_16, 2, Sphere, BallJoint>),
                   (BoundedWorld<Bounded<8>, q16_16, 2, Sphere, BallJoint>)) {
  STATIC_REQUIRE(std::is_nothrow_move_constructible_v<TestType> &&
                 std::is_nothrow_move_assignable_v<TestType>);
  const auto fill = [](TestType& world) {
    add_round_ground(world);
    BallJoint<q16_16, 2> joint;
    joint.a = add_ball(world, 0, 1);
    joint.b = add_ball(world, 0, 3);
    const auto id = world.add(joint);
    for (int i = 0; i < 10; ++i) world.step();
    return std::pair(joint.b, *id);
  };
  const auto check_is_new = [&](TestType& world) {
    CHECK(world.size() == 0);
    CHECK(world.joint_count() == 0);
    CHECK(world.event_count() == 0);
    CHECK(digest(world) == digest(TestType()));
    TestType fresh;
    CHECK(fill(world) == fill(fresh));
    CHECK(digest(world) == digest(fresh));
  };
  TestType first;
  fill(first);
  const auto before = digest(first);
  TestType second = std::move(first);
  CHECK(digest(second) == before);
  CHECK(second.joint_count() == 1);
  check_is_new(first);

  TestType third;
  add_ball(third, 5, 5);
  third = std::move(second);
  CHECK(digest(third) == before);
  CHECK(third.size() == 3);
  check_is_new(second);

  TestType& same = third;
  third = std::move(same);
  CHECK(digest(third) == before);
  first.step();
  third.step();
  std::swap(first, third);
  first.step();
  CHECK(digest(first) != before);
}

TEST_CASE("world: full worlds and wrong ids are refused") {
  BoundedWorld<Bounded<2>, q16_16, 2, Sphere> world;
  const Sphere<q16_16, 2> ball{{}, q16_16(1)};
  const auto first = world.add(ball);
  const auto second = world.add(ball);
  REQUIRE(first);
  REQUIRE(second);
  CHECK(!world.add(ball));
  CHECK(!world.put(*first, ball));
  REQUIRE(world.remove(*first));
  CHECK(!world.remove(*first));
  CHECK(world.position(*first) == Vec<q16_16, 2>());
  CHECK(world.put(*first, ball));
  CHECK(world.size() == 2);
  for (int t = 0; t < 60; ++t) world.step();
  CHECK(!(world.position(*first) == world.position(*second)));  // pushed apart
}

TEST_CASE("world: with room for two contacts, the first two balls on the ground stay on it") {
  using Roomy = BoundedWorld<Bounded<5>, q16_16, 2, Sphere>;
  using Narrow = BoundedWorld<Bounded<5, 0, 2>, q16_16, 2, Sphere>;
  STATIC_REQUIRE(Roomy::contact_capacity == 40 && Narrow::contact_capacity == 2);
  STATIC_REQUIRE(sizeof(Narrow) < sizeof(Roomy) / 4);
  const auto drop = [](auto world, int balls) {
    add_round_ground(world);
    for (int i = 0; i < balls; ++i) add_ball(world, 3 * i, 1);
    for (int t = 0; t < 120; ++t) world.step();
    return world;
  };
  const auto two = drop(Narrow(), 2);
  CHECK(digest(two) == digest(drop(Roomy(), 2)));
  const auto full = drop(Narrow(), 4);
  int on_ground = 0;
  full.for_each([&](const auto&, const Sphere<q16_16, 2>& ball) {
    on_ground += ball.radius == 1 && ball.center.y > -5 ? 1 : 0;
  });
  CHECK(on_ground == 2);
  Narrow restored;
  add_round_ground(restored);
  CHECK(restore(restored, snapshot(drop(World<q16_16, 2, Sphere>(), 2))) == Restored::yes);
  CHECK(restore(restored, snapshot(drop(World<q16_16, 2, Sphere>(), 4))) == Restored::no_room);
  CHECK(digest(restored) == digest(two));
}

}  // namespace
}  // namespace detent::test
