// SPDX-License-Identifier: MIT
//
// Sensors report fast bodies that pass them within one tick (docs/dynamics.md, step 11).

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "detent/dynamics/snapshot.hpp"
#include "dynamics/stage.hpp"
#include "support/catch.hpp"
#include "support/pool.hpp"

namespace detent::test {

namespace {

template <int N>
using Range = World<q16_16, N, Sphere, Capsule, Obb, BodyCompound>;

template <int N>
BodyOptions<q16_16, N> sensor() {
  BodyOptions<q16_16, N> options;
  options.motion = BodyMotion::fixed;
  options.is_sensor = true;
  return options;
}
template <int N>
BodyOptions<q16_16, N> bullet(double x, double y) {
  BodyOptions<q16_16, N> options;
  options.velocity = at<q16_16, N>(x, y);
  options.is_fast = true;
  return options;
}
template <int N>
Range<N> weightless() {
  WorldSettings<q16_16, N> settings;
  settings.gravity = {};
  return Range<N>(settings);
}

/// The events of the last step: `+0:1 ` for bodies 0 and 1 that begin to touch, with parts if they
/// are not 0.
template <class W>
std::string events_of(const W& world) {
  std::string text;
  const auto add = [&](const BodyId& id, std::uint32_t part) {
    text += std::to_string(id.index);
    if (part != 0) text += '.' + std::to_string(part);
  };
  for (std::size_t i = 0; i < world.event_count(); ++i) {
    const auto& event = world.event(i);
    text += event.begins ? '+' : '-';
    add(event.a, event.part_a);
    text += ':';
    add(event.b, event.part_b);
    text += ' ';
  }
  return text;
}
/// The events of each step, separated by bars.
template <class W>
std::string events_of(W& world, int ticks) {
  std::string text;
  for (int t = 0; t < ticks; ++t) {
    world.step();
    text += (t == 0 ? "" : "|") + events_of(std::as_const(world));
  }
  return text;
}

/// A ball of radius 0.05 at 500 units a second that starts 12.1 above a sensor plate of 0.02.
template <int N>
std::string shot(double x, bool is_fast, const BodyOptions<q16_16, N>& plate = sensor<N>()) {
  auto world = weightless<N>();
  (void)world.add(box_of<q16_16, N>(0, 0, 3, 0.01), plate);
  auto options = bullet<N>(0, -500);
  options.is_fast = is_fast;
  (void)world.add(Sphere<q16_16, N>{at<q16_16, N>(x, 12.1), num<q16_16>(0.05)}, options);
  return events_of(world, 4);
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("passes: a bullet through a sensor of 0.02 begins and ends in one tick", "",
                       ((int N), N), 2, 3) {
  for (const double x : {0.0, 2.9, 3.04}) {
    CAPTURE(x);
    CHECK(shot<N>(x, true) == "|+0:1 -0:1 ||");
  }
  CHECK(shot<N>(0, false) == "|||");    // without continuous collision nothing is promised
  CHECK(shot<N>(3.06, true) == "|||");  // beside the plate
  auto other = sensor<N>();
  other.layers = 2;
  CHECK(shot<N>(0, true) == "|+0:1 -0:1 ||");
  other.collides_with = 2;
  CHECK(shot<N>(0, true, other) == "|||");
}

TEMPLATE_TEST_CASE_SIG("passes: what touches at the end of a tick is left to the next", "",
                       ((int N), N), 2, 3) {
  for (int t = 0; t < 5; ++t) {  // the plate is where the ball is after t ticks
    auto world = weightless<N>();
    const auto step = num<q16_16>(100.0 / 60);
    (void)world.add(box_of<q16_16, N>(0, -t * static_cast<double>(step), 3, 0.01), sensor<N>());
    (void)world.add(Sphere<q16_16, N>{{}, num<q16_16>(0.05)}, bullet<N>(0, -100));
    std::string expected;
    for (int i = 0; i < 6; ++i) {
      if (i == t) expected += "+0:1 ";
      if (i == t + 1) expected += "-0:1 ";
      if (i < 5) expected += '|';
    }
    CHECK(events_of(world, 6) == expected);
  }
}

TEST_CASE("passes: what touches at the start of a tick has no second beginning") {
  auto world = weightless<2>();
  (void)world.add(box_of<q16_16, 2>(0, 0, 3, 0.01), sensor<2>());
  (void)world.add(Sphere<q16_16, 2>{at<q16_16, 2>(0, 0.04), num<q16_16>(0.05)}, bullet<2>(0, -500));
  CHECK(events_of(world, 3) == "+0:1 |-0:1 |");
}

TEST_CASE("passes: only what lies before the obstacle that stops the body is reported") {
  auto world = weightless<2>();
  const auto thin = [](double y) { return box_of<q16_16, 2>(0, y, 3, 0.01); };
  auto wall = sensor<2>();
  wall.is_sensor = false;
  (void)world.add(thin(2), sensor<2>());
  (void)world.add(thin(1), wall);
  (void)world.add(thin(0.5), sensor<2>());
  (void)world.add(Sphere<q16_16, 2>{at<q16_16, 2>(0, 4.1), num<q16_16>(0.05)}, bullet<2>(0, -500));
  CHECK(events_of(world, 3) == "+0:3 -0:3 |+1:3 |");
}

TEST_CASE("passes: moving sensors, fast sensors and parts of compounds") {
  // A sensor passes a ball that rests, and a fast sensor a ball that is not fast.
  auto moving = weightless<2>();
  auto plate = sensor<2>();
  plate.motion = BodyMotion::kinematic;
  plate.velocity = at<q16_16, 2>(0, 300);
  (void)moving.add(box_of<q16_16, 2>(0, -2, 3, 0.01), plate);
  (void)moving.add(Sphere<q16_16, 2>{{}, num<q16_16>(0.05)}, bullet<2>(0, 0));
  CHECK(events_of(moving, 2) == "+0:1 -0:1 |");

  auto swept = weightless<2>();
  auto eye = bullet<2>(0, -300);
  eye.is_sensor = true;
  (void)swept.add(Sphere<q16_16, 2>{at<q16_16, 2>(0, 2), num<q16_16>(0.05)}, eye);
  (void)swept.add(Sphere<q16_16, 2>{{}, num<q16_16>(0.05)});
  CHECK(events_of(swept, 2) == "+0:1 -0:1 |");
  eye.velocity = at<q16_16, 2>(0, 300);  // two fast bodies meet: one pass
  (void)swept.add(Sphere<q16_16, 2>{at<q16_16, 2>(1, -2), num<q16_16>(0.05)}, eye);
  (void)swept.add(Sphere<q16_16, 2>{at<q16_16, 2>(1, 2), num<q16_16>(0.05)}, bullet<2>(0, -300));
  CHECK(events_of(swept, 1) == "+2:3 -2:3 ");

  PartOptions<q16_16> zone;
  zone.is_sensor = true;
  const std::vector gate{BodyPart(box_of<q16_16, 2>(0, 3, 0.01, 1)),
                         BodyPart(box_of<q16_16, 2>(0, 0, 0.01, 1), zone),
                         BodyPart(box_of<q16_16, 2>(0.5, 0, 0.01, 1), zone)};
  const std::vector dart{BodyPart(Sphere<q16_16, 2>{at<q16_16, 2>(0.2, 0), num<q16_16>(0.05)}),
                         BodyPart(box_of<q16_16, 2>(0, 0, 0.2, 0.06))};
  const auto gates = solid_compound(1, std::span(gate)), darts = solid_compound(2, std::span(dart));
  REQUIRE(gates);
  REQUIRE(darts);
  auto parts = weightless<2>();
  auto fixed = sensor<2>();
  fixed.is_sensor = false;
  (void)parts.add(BodyCompound<q16_16, 2>{&*gates, {}, {}}, fixed);
  (void)parts.add(BodyCompound<q16_16, 2>{&*darts, at<q16_16, 2>(-2, 0.1), {}}, bullet<2>(300, 0));
  CHECK(events_of(parts, 2) == "+0.1:1.1 -0.1:1.1 +0.2:1.1 -0.2:1.1 |");

  // A compound whose center is in none of its parts: the center counts for the first.
  const std::vector horns{BodyPart(Sphere<q16_16, 2>{at<q16_16, 2>(0, -0.2), num<q16_16>(0.05)}),
                          BodyPart(Sphere<q16_16, 2>{at<q16_16, 2>(0, 0.2), num<q16_16>(0.05)})};
  const auto fork = solid_compound(3, std::span(horns));
  REQUIRE(fork);
  auto open = weightless<2>();
  (void)open.add(box_of<q16_16, 2>(0, 0, 0.01, 1), sensor<2>());
  (void)open.add(BodyCompound<q16_16, 2>{&*fork, at<q16_16, 2>(-2, 0.1), {}}, bullet<2>(300, 0));
  CHECK(events_of(open, 2) == "+0:1 -0:1 |");
}

TEST_CASE("passes: sensors change no state, and neither copies nor snapshots lose events") {
  const auto level = [](bool has_sensors) {
    auto world = weightless<3>();
    if (!has_sensors) return world;
    for (const double y : {2.0, 0.0, -5.0, -9.0}) {
      (void)world.put({static_cast<std::uint32_t>(20 + y), 99}, box_of<q16_16, 3>(0, y, 9, 0.01),
                      sensor<3>());
    }
    return world;
  };
  const auto shoot = [](Range<3>& world) {
    for (int i = 0; i < 6; ++i) {
      (void)world.put({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(i + 1)},
                      Sphere<q16_16, 3>{at<q16_16, 3>(i, 9 + 0.7 * i), num<q16_16>(0.05)},
                      bullet<3>(10, -300 - 40 * i));
    }
  };
  auto world = level(true), empty = level(false);
  shoot(world);
  shoot(empty);
  auto by_two = world, by_four = world;
  Pool two(2), four(4);
  int passes = 0, touching = 0;
  for (int t = 0; t < 8; ++t) {
    CAPTURE(t);
    auto copy = world;
    auto restored = level(true);
    REQUIRE(restore(restored, snapshot(world)) == Restored::yes);
    world.step();
    empty.step();
    copy.step();
    restored.step();
    by_two.step(two);
    by_four.step(four);
    const auto events = events_of(world);
    for (std::size_t i = 0; i < world.event_count(); ++i) {
      passes += world.event(i).begins ? 1 : 0;
      touching += world.event(i).begins ? 1 : -1;
    }
    int listed = 0;
    world.for_each_touch([&](const TouchEvent& touch) { listed += touch.begins ? 1 : 9; });
    REQUIRE(listed == touching);
    REQUIRE(events_of(copy) == events);
    REQUIRE(events_of(restored) == events);
    REQUIRE(events_of(by_two) == events);
    REQUIRE(events_of(by_four) == events);
    for (std::uint32_t i = 0; i < 6; ++i) {
      REQUIRE(digest_of(world, {i, i + 1}) == digest_of(empty, {i, i + 1}));
    }
    REQUIRE(digest(by_four) == digest(world));
  }
  CHECK(passes == 6 * 4);
}

}  // namespace detent::test
