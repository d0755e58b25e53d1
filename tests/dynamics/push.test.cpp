// SPDX-License-Identifier: MIT
//
// Impulses, forces, torques, locked axes, sensors and per-body gravity. tests/dynamics/twin
// compares their bits with a second implementation.
#include <cmath>
#include <vector>

#include "detent/dynamics/snapshot.hpp"
#include "dynamics/scenes.hpp"
#include "dynamics/stage.hpp"
#include "dynamics/step_alike.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"
#include "support/seal.hpp"

namespace detent::test {
namespace {

using S = q16_16;
using Flat = World<S, 2, Sphere, Obb>;
using Solid = World<S, 3, Sphere, Obb>;

template <int N>
WorldSettings<S, N> weightless() {
  WorldSettings<S, N> settings;
  settings.gravity = {};
  return settings;
}
double d(const S& x) { return static_cast<double>(x); }
bool is_close(const S& x, double y, double by = 1e-3) { return std::fabs(d(x) - y) <= by; }

template <int N>
BodyOptions<S, N> locking(std::uint8_t locked) {
  BodyOptions<S, N> options;
  options.locked = locked;
  return options;
}

}  // namespace

TEST_CASE("push: an impulse at the center changes the velocity by impulse over mass") {
  Flat world(weightless<2>());
  const auto box = *world.add(box_at<S, 2>(3, 2, 1, 0.5));  // of mass 2
  world.apply_impulse(box, {S(4), S(-1)});
  CHECK(is_close(world.velocity(box).x, 2));
  CHECK(is_close(world.velocity(box).y, -0.5));
  CHECK(world.angular_velocity(box)[0] == S(0));
  world.apply_impulse(box, {S(-4), S(1)});
  CHECK(world.velocity(box) == Vec<S, 2>{});
}

TEST_CASE("push: an off-center impulse also turns the body") {
  Flat world(weightless<2>());
  const auto box = *world.add(box_at<S, 2>(3, 2, 1, 0.5));  // inertia 2 (2^2 + 1^2) / 12
  world.apply_impulse(box, {{}, S(1)}, {S(4), S(2)});
  CHECK(is_close(world.velocity(box).y, 0.5));
  CHECK(is_close(world.angular_velocity(box)[0], 1.2));
  Solid solid(weightless<3>());
  const auto ball = *solid.add(Sphere<S, 3>{{S(1), {}, {}}, S(1)});
  const double inertia = 0.4 * 4 * 3.14159265 / 3;
  solid.apply_impulse(ball, {{}, S(1), {}}, {S(1), {}, S(1)});
  CHECK(is_close(solid.angular_velocity(ball)[0], -1 / inertia));
  CHECK(solid.angular_velocity(ball)[1] == S(0));
  CHECK(solid.angular_velocity(ball)[2] == S(0));
}

TEST_CASE("push: a force acts for one step and adds to other forces") {
  Flat world(weightless<2>());
  const auto box = *world.add(box_at<S, 2>(0, 0, 1, 0.5));
  for (int tick = 1; tick <= 60; ++tick) {
    world.apply_force(box, {S(3), {}});
    world.apply_force(box, {S(1), S(2)});
    CHECK(is_close(world.velocity(box).x, 2.0 * (tick - 1) / 60));
    world.step();
  }
  CHECK(is_close(world.velocity(box).x, 2, 2e-3));
  CHECK(is_close(world.velocity(box).y, 1, 2e-3));
  const auto velocity = world.velocity(box);
  world.step();
  CHECK(world.velocity(box) == velocity);
  for (int tick = 0; tick < 60; ++tick) {
    world.apply_force(box, {S(-4), S(-2)});
    world.apply_torque(box, {S(1)});
    world.step();
  }
  CHECK(is_close(world.velocity(box).x, 0, 2e-3));
  CHECK(is_close(world.angular_velocity(box)[0], 1.2, 3e-3));
}

TEST_CASE("push: a force at a point equals a force at the center and a torque") {
  for (const int y : {-3, 0, 2}) {
    Flat at_point(weightless<2>()), apart(weightless<2>());
    const auto a = *at_point.add(box_at<S, 2>(1, 1, 1, 0.5));
    const auto b = *apart.add(box_at<S, 2>(1, 1, 1, 0.5));
    at_point.apply_force(a, {S(2), S(1)}, {S(3), S(y)});
    apart.apply_force(b, {S(2), S(1)});
    apart.apply_torque(b, {S(2 * 1 - (y - 1) * 2)});
    at_point.step();
    apart.step();
    CHECK(digest(at_point) == digest(apart));
  }
}

TEST_CASE("push: wakes sleeping bodies and leaves immovable ones alone") {
  Flat world;
  BodyOptions<S, 2> options;
  options.motion = BodyMotion::fixed;
  const auto floor = *world.add(box_at<S, 2>(0, -1, 9, 1), options);
  options.motion = BodyMotion::kinematic;
  const auto driven = *world.add(box_at<S, 2>(5, 5, 1, 1), options);
  const auto box = *world.add(box_at<S, 2>(0, 0.5, 0.5, 0.5));
  for (int i = 0; i < 120; ++i) world.step();
  REQUIRE(world.is_asleep(box));
  const auto before = digest(world);
  for (const auto id : {floor, driven, BodyId{7, 1}}) {
    world.apply_impulse(id, {S(9), {}});
    world.apply_impulse(id, {S(9), {}}, {S(1), {}});
    world.apply_force(id, {S(9), {}});
    world.apply_force(id, {S(9), {}}, {S(1), {}});
    world.apply_torque(id, {S(9)});
  }
  CHECK(digest(world) == before);
  world.apply_force(box, {});
  CHECK_FALSE(world.is_asleep(box));
}

TEST_CASE("push: the largest numbers clamp") {
  Solid world(weightless<3>());
  auto options = BodyOptions<S, 3>();
  options.density = S::from_raw(1);
  const auto box = *world.add(box_at<S, 3>(0, 0, 0.02, 0.03), options);
  const S most = S::max(), least = S::lowest();
  for (int i = 0; i < 5; ++i) {
    world.apply_impulse(box, {most, most, least}, {least, most, most});
    world.apply_force(box, {most, most, least}, {least, most, most});
    world.apply_torque(box, {most, least, most});
    world.step();
  }
  CHECK(d(world.velocity(box).x) > 900);
}

TEST_CASE("push: pending forces are in snapshots and digests") {
  Flat world;
  const auto box = *world.add(box_at<S, 2>(0, 3, 1, 0.5));
  const auto twin = *world.add(box_at<S, 2>(4, 3, 1, 0.5));
  const auto plain = snapshot(world).size();
  const auto before = digest(world);
  world.apply_force(box, {S(3), {}}, {{}, S(4)});
  CHECK(digest(world) != before);
  CHECK(snapshot(world).size() == plain + 12);
  Flat other;
  REQUIRE(restore(other, snapshot(world)) == Restored::yes);
  CHECK(digest(other) == digest(world));
  step_alike(world, other, 10);
  CHECK(snapshot(world).size() == plain);
  CHECK(d(world.velocity(box).x) > 0);
  CHECK(world.velocity(twin).x == S(0));
}

TEST_CASE("push: locked axes, sensors and per-body gravity are in snapshots") {
  Flat world;
  auto options = locking<2>(AxisLock::x | AxisLock::turn);
  const auto locked = *world.add(box_at<S, 2>(0, 3, 1, 0.5), options);
  options = {};
  options.is_sensor = true;
  const auto sensor = *world.add(box_at<S, 2>(0, 1, 1, 0.5), options);
  options = {};
  options.gravity_scale = S(2);
  const auto heavy = *world.add(box_at<S, 2>(5, 1, 1, 0.5), options);
  (void)world.add(box_at<S, 2>(9, 1, 1, 0.5), options);
  const auto start = digest_of(world, locked);
  Flat other;
  REQUIRE(restore(other, snapshot(world)) == Restored::yes);
  step_alike(world, other, 40);
  CHECK(digest_of(world, locked) != start);
  CHECK(world.contains(sensor));
  CHECK(is_close(world.velocity(heavy).y, -2 * 10 * 40 / 60.0, 0.02));
  // A snapshot that spells out defaults or zero pushes, or has unknown bits, is invalid.
  detail::WorldAccess::bodies(world)[0].push.x = detail::Formats<S>::Speed::from_raw(1);
  auto bytes = snapshot(world);
  for (std::size_t i = 56; i + 8 < bytes.size(); ++i) {
    const auto whole = bytes;
    for (int bit = 0; bit < 8; ++bit) {
      bytes[i] ^= std::byte{1} << bit;
      seal(bytes);
      Flat again;
      if (restore(again, bytes) == Restored::yes) CHECK(snapshot(again) == bytes);
      bytes = whole;
    }
  }
}

TEST_CASE("push: no collision moves a body along a locked axis or turns it about one") {
  Solid world;
  BodyOptions<S, 3> fixed;
  fixed.motion = BodyMotion::fixed;
  (void)world.add(box_at<S, 3>(0, -1, 20, 1), fixed);
  Random random(11);
  std::vector<BodyId> ids;
  std::vector<std::uint8_t> locks;
  for (int i = 0; i < 30; ++i) {
    locks.push_back(static_cast<std::uint8_t>(random.below(64)));
    auto box = box_at<S, 3>(0.3 * (i % 5) - 0.6, 0.6 + 0.5 * i, 0.3, 0.25);
    box.center.z = num<S>(0.2 * (i % 3));
    ids.push_back(*world.add(box, locking<3>(locks.back())));
  }
  std::vector<Vec<S, 3>> start;
  for (const auto id : ids) start.push_back(world.position(id));
  int moved = 0;
  for (int tick = 0; tick < 240; ++tick) {
    const auto k = random.below(ids.size());
    world.apply_impulse(ids[k], {S(1), S(1), S(-1)}, {S(1), {}, S(1)});
    world.apply_force(ids[k], {S(1), S(9), S(1)});
    world.apply_torque(ids[k], {S(1), S(1), S(1)});
    world.step();
    for (std::size_t i = 0; i < ids.size(); ++i) {
      for (int axis = 0; axis < 3; ++axis) {
        if (((locks[i] >> axis) & 1) != 0) {
          REQUIRE(world.position(ids[i])[axis] == start[i][axis]);
          REQUIRE(world.velocity(ids[i])[axis] == S(0));
        } else {
          moved += world.position(ids[i])[axis] != start[i][axis] ? 1 : 0;
        }
        if (((locks[i] >> (axis + 3)) & 1) != 0) {
          REQUIRE(world.angular_velocity(ids[i])[static_cast<std::size_t>(axis)] == S(0));
        }
      }
    }
  }
  CHECK(moved > 5000);
}

TEST_CASE("push: a box that cannot turn rests upright on its edge and carries another one") {
  Flat world;
  BodyOptions<S, 2> fixed;
  fixed.motion = BodyMotion::fixed;
  (void)world.add(box_at<S, 2>(0, -1, 1, 1), fixed);
  const auto box = *world.add(box_at<S, 2>(1.4, 0.5, 0.5, 0.5), locking<2>(AxisLock::turn));
  // Held in x and y by its locks, it is a shelf.
  const auto shelf = *world.add(box_at<S, 2>(5, 1, 1, 0.25),
                                locking<2>(AxisLock::x | AxisLock::y | AxisLock::turn));
  const auto ball = *world.add(Sphere<S, 2>{{S(5), S(3)}, num<S>(0.5)});
  for (int i = 0; i < 240; ++i) world.step();
  CHECK(is_close(world.position(box).y, 0.5, 0.02));
  CHECK(world.rotation(box).axis(0) == Direction<S, 2>::along(0));
  CHECK(world.position(shelf).y == S(1));
  CHECK(is_close(world.position(ball).y, 1.75, 0.02));
  CHECK(world.is_asleep(ball));
}

TEST_CASE("push: a sensor reports what enters and leaves, and moves nothing") {
  for (const auto motion : {BodyMotion::fixed, BodyMotion::kinematic, BodyMotion::dynamic}) {
    Flat world, without;
    BodyOptions<S, 2> options;
    options.motion = motion;
    options.is_sensor = true;
    options.gravity_scale = S(0);
    const auto zone = *world.add(box_at<S, 2>(0, 3, 1, 1), options);
    const auto ball = *world.add(Sphere<S, 2>{{{}, S(8)}, num<S>(0.5)});
    const auto free = *without.add(Sphere<S, 2>{{{}, S(8)}, num<S>(0.5)});
    std::vector<TouchEvent> events;
    S above{}, below{};
    for (int i = 0; i < 120; ++i) {
      world.step();
      without.step();
      REQUIRE(world.position(ball) == without.position(free));
      REQUIRE(world.velocity(ball) == without.velocity(free));
      for (std::size_t k = 0; k < world.event_count(); ++k) {
        events.push_back(world.event(k));
        (events.back().begins ? above : below) = world.position(ball).y;
      }
    }
    REQUIRE(events.size() == 2);
    CHECK(events[0] == TouchEvent{zone, ball, true});
    CHECK(events[1] == TouchEvent{zone, ball, false});
    // Detected in the step after: two ticks at 8 and at 11 units per second.
    CHECK(is_close(above, 4.35, 0.15));
    CHECK(is_close(below, 1.3, 0.2));
    CHECK(world.position(zone) == Vec<S, 2>{{}, S(3)});
  }
}

TEST_CASE("push: a sensor neither wakes bodies nor keeps them awake") {
  Flat world;
  BodyOptions<S, 2> options;
  options.motion = BodyMotion::fixed;
  (void)world.add(box_at<S, 2>(0, -1, 9, 1), options);
  const auto box = *world.add(box_at<S, 2>(0, 0.5, 0.5, 0.5));
  options.motion = BodyMotion::kinematic;
  options.is_sensor = true;
  options.velocity = {num<S>(0.25), {}};
  (void)world.add(box_at<S, 2>(-1.5, 0.5, 0.5, 0.5), options);
  int touches = 0;
  for (int i = 0; i < 300; ++i) {
    world.step();
    for (std::size_t k = 0; k < world.event_count(); ++k) touches += world.event(k).begins;
    if (i > 60) REQUIRE(world.is_asleep(box));
  }
  CHECK(touches == 2);  // the floor and the sensor
}

TEST_CASE("push: bodies without gravity float, and fall up with a negative scale") {
  Flat world;
  BodyOptions<S, 2> options;
  options.gravity_scale = S(0);
  const auto still = *world.add(Sphere<S, 2>{{{}, S(8)}, num<S>(0.5)}, options);
  options.gravity_scale = num<S>(-0.5);
  const auto up = *world.add(Sphere<S, 2>{{S(5), S(8)}, num<S>(0.5)}, options);
  for (int i = 0; i < 60; ++i) world.step();
  CHECK(world.position(still) == Vec<S, 2>{{}, S(8)});
  CHECK(is_close(world.velocity(up).y, 5, 0.01));
}

}  // namespace detent::test
