// SPDX-License-Identifier: MIT
#include "detent/dynamics/hold.hpp"

#include "dynamics/crowd.hpp"
#include "dynamics/scenes.hpp"
#include "dynamics/step_alike.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

template <class World>
std::size_t held_in(const World& world) {
  const auto& bodies = detail::WorldAccess::bodies(world);
  std::size_t count = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) count += bodies[i].is_held();
  return count;
}

/// A scene of `settle` in q16_16 and in double.
struct Both {
  Settled fixed, real;
};
template <class Make>
Both settle_both(const Make& make, int ticks) {
  return {settle(make(q16_16()), ticks), settle(make(double()), ticks)};
}

}  // namespace

TEST_CASE("hold: without it a stack of 20 falls at 4 substeps") {
  const auto settled = settle(stack<q16_16, 3>(20, 4, 0, 0), 1300);
  CHECK(settled.dy < -10);
}

TEST_CASE("hold: a stack of 20 stands upright at 4 substeps") {
  const auto [fixed, real] = settle_both([](auto s) { return stack<decltype(s), 3>(20, 4); }, 600);
  for (const auto& settled : {fixed, real}) {
    CHECK(settled.rest >= 0);
    CHECK(settled.rest < 40);
    CHECK(std::fabs(settled.dy + 0.0825) < 0.0005);
    CHECK(std::fabs(settled.dx) < 0.001);
  }
  CHECK(fixed.digest == 0x0e5728d79104328c);
}

TEST_CASE("hold: a house of cards and a stack in 2D rest") {
  const auto cards = settle_both([](auto s) { return house_of_cards<decltype(s)>(3, 4); }, 600);
  for (const auto& settled : {cards.fixed, cards.real}) {
    CHECK(settled.rest >= 0);
    CHECK(settled.rest < 60);
    CHECK(std::fabs(settled.dy) < 0.02);
    CHECK(std::fabs(settled.dx) < 0.02);
  }
  CHECK(cards.fixed.digest == 0x2415b787debf0a16);
  const auto boxes = settle_both([](auto s) { return stack<decltype(s), 2>(20, 4); }, 600);
  for (const auto& settled : {boxes.fixed, boxes.real}) {
    CHECK(settled.rest >= 0);
    CHECK(settled.rest < 40);
    CHECK(std::fabs(settled.dx) < 0.001);
  }
  CHECK(boxes.fixed.digest == 0x69a24ad2b72e8bbe);
}

TEST_CASE("hold: a body is held until it has moved or turned too far") {
  Scene<q16_16, 2> scene(4);
  scene.options.friction = q16_16(0);
  scene.options.velocity = at<q16_16, 2>(1, 0);
  scene.add(box_at<q16_16, 2>(0, 0.5, 0.5, 0.5));
  const auto& pace = detail::WorldAccess::pace(scene.world);
  const auto& body = detail::WorldAccess::bodies(scene.world)[scene.top.index];
  int renewals = 0;
  auto before = body.state.place.x;
  for (int t = 0; t < 60; ++t) {
    scene.step(1);
    CHECK(abs(body.drift.x) <= pace.hold);
    const auto at = detail::held_support(body).place.x;
    renewals += at != before;
    before = at;
  }
  CHECK(renewals > 8);  // each 6 or 7 ticks
  CHECK(renewals < 12);

  Scene<q16_16, 2> turning(4);
  turning.options.angular_velocity = {num<q16_16>(0.3)};  // 0.005 a tick
  turning.add(box_at<q16_16, 2>(0, 0.268, 0.25, 0.25));
  const auto& other = detail::WorldAccess::bodies(turning.world)[turning.top.index];
  turning.step(1);
  REQUIRE(other.is_held());
  const auto first = other.anchor;
  turning.step(1);  // by 0.005, less than 1/128
  CHECK(other.anchor == first);
  CHECK(detail::lean_of(other)[0] > detail::Formats<q16_16>::Spin::from_double(0.004));
  turning.step(1);
  CHECK(other.anchor != first);
  CHECK(detail::lean_of(other)[0] < detail::Formats<q16_16>::Spin::from_double(0.0003));

  Scene<q16_16, 2> falling(4);
  falling.add(box_at<q16_16, 2>(0, 50, 0.5, 0.5));
  falling.step(1);
  CHECK(!detail::WorldAccess::bodies(falling.world)[falling.top.index].is_held());
}

TEST_CASE("hold: contacts of slowly approaching bodies are found in time") {
  // The box slides to a wall at less than the distance a tick, so that it is held all the way.
  for (const double hold_distance : {0.0, 0.5}) {
    Scene<q16_16, 2> scene(4, 0, hold_distance);
    const auto wall = box_at<q16_16, 2>(3, 1, 0.5, 1);
    scene.world.add(wall, {.motion = BodyMotion::fixed});
    scene.options.friction = q16_16(0);
    scene.options.velocity = at<q16_16, 2>(1, 0);
    scene.add(box_at<q16_16, 2>(0, 0.5, 0.5, 0.5));
    for (int t = 0; t < 240; ++t) {
      scene.step(1);
      CHECK(scene.world.position(scene.top).x < num<q16_16>(2.001));
    }
    CHECK(scene.world.position(scene.top).x > num<q16_16>(1.99));
  }
}

TEST_CASE("hold: worlds restored from a snapshot continue bit for bit") {
  const Crowd crowd(5);
  auto world = crowd.world();
  std::size_t held = 0;
  for (int t = 0; t < 60; ++t) {
    world.step();
    held = (std::max)(held, held_in(world));
    if (t % 20 != 19) continue;
    auto restored = crowd.world();
    const auto bytes = snapshot(world);
    REQUIRE(restore(restored, bytes, crowd.compounds(), crowd.meshes()) == Restored::yes);
    CHECK(snapshot(restored) == bytes);
    auto copy = world;
    step_alike(copy, restored, 10);
  }
  CHECK(held > 10);
}

TEST_CASE("hold: snapshots with a body beyond the limits, or for other settings, are rejected") {
  auto scene = stack<q16_16, 2>(3, 4);
  scene.step(5);
  auto fresh = stack<q16_16, 2>(3, 4);
  CHECK(restore(fresh.world, snapshot(scene.world)) == Restored::yes);
  auto& body = detail::WorldAccess::bodies(scene.world)[scene.top.index];
  const auto& pace = detail::WorldAccess::pace(scene.world);
  REQUIRE(body.is_held());
  const auto as_it_was = body;
  const auto restored = [&] { return restore(fresh.world, snapshot(scene.world)); };
  using Place = detail::Formats<q16_16>::Place;
  using Speed = detail::Formats<q16_16>::Speed;
  const auto held_at = detail::held_support(body).place.x;
  for (const int away : {-1, 1}) {
    // As far as it may be from where it is held, and one step farther.
    for (const int beyond : {0, 1}) {
      body.drift.x = Speed::from_raw((pace.hold.raw() + beyond) * away);
      body.state.place.x = saturate_to<Place>(held_at + body.drift.x);
      CHECK(restored() == (beyond == 0 ? Restored::yes : Restored::corrupted));
    }
    body = as_it_was;
  }
  using Anchor = detail::Formats<q16_16>::Anchor;
  const auto near = detail::anchored<q16_16>(body.state.orientation.y).raw();
  for (const int steps : {-33, -32, 32, 33}) {
    body.anchor.y = Anchor::from_raw(static_cast<Anchor::raw_type>(near + steps));
    CHECK(restored() == (std::abs(steps) == 32 ? Restored::yes : Restored::corrupted));
  }
  body = as_it_was;
  auto other = stack<q16_16, 2>(3, 4, 0, 0);
  CHECK(restore(other.world, snapshot(fresh.world)) == Restored::other_scene);
}

TEST_CASE("hold: places at which bodies are held are on a grid, also at the end of the world") {
  Scene<q16_16, 2> scene(4);
  scene.world.add(box_at<q16_16, 2>(32750, 1, 17.98, 1), {.motion = BodyMotion::fixed});
  scene.options.friction = q16_16(0);
  scene.options.velocity = at<q16_16, 2>(2, 0);
  scene.add(box_at<q16_16, 2>(32767.25, 2.5, 0.5, 0.5));
  const auto& body = detail::WorldAccess::bodies(scene.world)[scene.top.index];
  const auto grid = std::int64_t{1} << detail::WorldAccess::pace(scene.world).hold_grid;
  CHECK(grid == 1 << 15);
  for (int t = 0; t < 60; ++t) {
    scene.step(1);
    REQUIRE(body.is_held());
    for (int i = 0; i < 2; ++i) {
      CHECK((std::int64_t{body.state.place[i].raw()} - body.drift[i].raw()) % grid == 0);
    }
    auto restored = Scene<q16_16, 2>(4);
    restored.world.add(box_at<q16_16, 2>(32750, 1, 17.98, 1), {.motion = BodyMotion::fixed});
    REQUIRE(restore(restored.world, snapshot(scene.world)) == Restored::yes);
    CHECK(digest(restored.world) == digest(scene.world));
  }
  CHECK(body.state.place.x == (detail::Formats<q16_16>::Place::max)());
}

TEST_CASE("hold: a bounded world has the same bits as one that solves contacts four at once") {
  auto scene = stack<q16_16, 3>(12, 4);
  BoundedWorld<Bounded<16>, q16_16, 3, Obb> world(scene.world.settings());
  (void)world.add(box_at<q16_16, 3>(0, -1, 50, 1), {.motion = BodyMotion::fixed});
  for (int i = 0; i < 12; ++i) (void)world.add(box_at<q16_16, 3>(0, 0.5 + i, 0.5, 0.5));
  for (int t = 0; t < 60; ++t) {
    scene.step(1);
    world.step();
    REQUIRE(digest(world) == digest(scene.world));
  }
}

}  // namespace detent::test
