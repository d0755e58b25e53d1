// SPDX-License-Identifier: MIT
//
// Contacts of bodies, against what statics and geometry say of simple scenes, and against exact
// rationals. tests/dynamics/world_contact_zoo.test.cpp has bodies of every kind.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "detent/dynamics/dynamics.hpp"
#include "dynamics/exact.hpp"
#include "dynamics/stage.hpp"
#include "dynamics/terrain.hpp"
#include "oracle/space.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

template <class World>
auto contacts_of(const World& world) {
  std::vector<WorldContact<q16_16, World::dimension>> found;
  world.for_each_contact([&](const auto& contact) { found.push_back(contact); });
  return found;
}
template <class World>
void step(World& world, int ticks) {
  for (int i = 0; i < ticks; ++i) world.step();
}
template <class S>
double d(const S& x) {
  return static_cast<double>(x);
}
/// Half a step of a scalar, and a little for numbers that were rounded before.
template <class S>
double step_of() {
  if constexpr (is_fixed<S>) {
    return d(S::assume_raw(1));
  } else {
    return 1e-5;
  }
}

/// A world in which nothing sleeps.
template <class S, int N>
WorldSettings<S, N> restless() {
  WorldSettings<S, N> settings;
  settings.sleep_speed = {};
  return settings;
}

}  // namespace

TEMPLATE_TEST_CASE("contacts: a box at rest is pushed by its weight at its corners", "",
                   DETENT_EVERY_SCALAR) {
  using S = TestType;
  const auto test = [](auto world) {
    constexpr int N = decltype(world)::dimension;
    constexpr double weight = 10.0 / 240;  // in a substep
    const auto floor = *world.add(box_of<S, N>(0, -1, 4, 1), {.motion = BodyMotion::fixed});
    const auto box = *world.add(box_of<S, N>(0, 0.5, 0.5, 0.5));
    step(world, 60);
    int count = 0;
    double sum = 0;
    world.for_each_contact([&](const WorldContact<S, N>& contact) {
      ++count;
      CHECK(contact.a == floor);
      CHECK(contact.b == box);
      CHECK(contact.triangle == 0);
      CHECK(std::fabs(d(contact.normal[1]) - 1) < 1e-3);
      REQUIRE(contact.count == (N == 2 ? 2 : 4));
      CHECK(std::fabs(d(contact.impulse) - weight) < 0.02 * weight + step_of<S>());
      const double sag = d(world.position(box).y) - 0.5;
      for (std::size_t i = 0; i < contact.count; ++i) {
        const auto& point = contact.points[i];
        sum += d(point.impulse);
        CHECK(std::fabs(std::fabs(d(point.point.x)) - 0.5) < 1e-3 + 2 * step_of<S>());
        CHECK(std::fabs(d(point.separation) - sag) < 1e-3 + 2 * step_of<S>());
        CHECK(std::fabs(d(point.point.y) - sag / 2) < 1e-3 + 2 * step_of<S>());
      }
      CHECK(std::fabs(sum - d(contact.impulse)) <= 2.5 * step_of<S>());
      for (int i = 0; i < N; ++i) CHECK(std::fabs(d(contact.friction[i])) < 1e-3 + step_of<S>());
    });
    CHECK(count == 1);
  };
  test(World<S, 2, Obb>(restless<S, 2>()));
  test(World<S, 3, Obb>(restless<S, 3>()));
  test(BoundedWorld<Bounded<4>, S, 2, Obb>(restless<S, 2>()));
  test(BoundedWorld<Bounded<4>, S, 3, Obb, Sphere>(restless<S, 3>()));
}

TEMPLATE_TEST_CASE("contacts: friction holds a box on a slope, along the slope", "", q16_16, float,
                   double) {
  using S = TestType;
  const auto test = []<int N>(WorldSettings<S, N> settings) {
    settings.gravity.x = S(3);  // a slope of 3 in 10
    World<S, N, Obb> world(settings);
    const auto box = *world.add(box_of<S, N>(0, 0.5, 0.5, 0.5), {.density = S(4)});
    const auto floor = *world.add(box_of<S, N>(0, -1, 4, 1), {.motion = BodyMotion::fixed});
    step(world, 60);
    int count = 0;
    world.for_each_contact(box, [&](const WorldContact<S, N>& contact) {
      ++count;
      CHECK(contact.b == floor);  // gets the opposite of what holds the box
      CHECK(std::fabs(d(contact.normal[1]) + 1) < 1e-3);
      CHECK(std::fabs(d(contact.impulse) - 4 * 10.0 / 240) < 0.02 * 4 * 10 / 240);
      CHECK(std::fabs(d(contact.friction.x) - 4 * 3.0 / 240) < 0.02 * 4 * 3 / 240);
      CHECK(std::fabs(d(contact.friction.y)) < 1e-3);
    });
    CHECK(count == 1);
  };
  test(restless<S, 2>());
  test(restless<S, 3>());
}

TEST_CASE("contacts: a ball between two others, in exact numbers") {
  using S = q16_16;
  auto settings = restless<S, 3>();
  settings.hold_distance = {};
  World<S, 3, Sphere> world(settings);
  const auto low = *world.add(Sphere<S, 3>{at3(0, 0, 0), num<S>(1)}, {.motion = BodyMotion::fixed});
  const auto middle = *world.add(Sphere<S, 3>{at3(0.125, 1.75, 0.25), num<S>(0.75)});
  const auto top =
      *world.add(Sphere<S, 3>{at3(0.25, 2.875, 0.125), num<S>(0.5)}, {.density = S(9)});
  int seen = 0;
  for (int tick = 0; tick < 40; ++tick) {
    world.step();
    const auto& bodies = detail::WorldAccess::bodies(world);
    const auto& stored = detail::WorldAccess::contacts(world);
    world.for_each_contact([&](const WorldContact<S, 3>& contact) {
      ++seen;
      REQUIRE(contact.count == 1);
      CHECK((contact.a == low ? contact.b == middle : contact.a == middle && contact.b == top));
      const auto &a = bodies[contact.a.index], &b = bodies[contact.b.index];
      const auto& own = *std::find_if(&stored[0], &stored[0] + stored.size(), [&](const auto& one) {
        return one.a == contact.a.index && one.b == contact.b.index;
      });
      // The impulse: pressure times substeps per second over the sum of inverse masses.
      const Rational inverse_a = a.can_move() ? 1 / exact(a.mass) : Rational(0);
      const Rational impulse = exact(own.pressure[0]) * 240 / (inverse_a + 1 / exact(b.mass));
      const Rational half_step = Rational(1) / (2 << 16);
      CHECK(abs(exact(contact.impulse) - impulse) <= half_step);
      CHECK(contact.impulse == contact.points[0].impulse);
      // Separation and point: (|b - a| - r_a - r_b), and in the middle between both surfaces.
      const double r_a = contact.a == low ? 1 : 0.75, r_b = contact.b == top ? 0.5 : 0.75;
      Rational squared = 0, offset = 0;
      for (int k = 0; k < 3; ++k) {
        const Rational way = exact(b.state.place[k]) - exact(a.state.place[k]);
        squared += way * way;
      }
      const Rational distance = exact(contact.points[0].separation) + Rational(r_a) + Rational(r_b);
      const Rational error = half_step + Rational(1) / (1 << 20);  // levers are rounded to 2^-22
      CHECK((distance - error) * (distance - error) < squared);
      CHECK((distance + error) * (distance + error) > squared);
      const double length = std::sqrt(squared.template convert_to<double>());
      for (int k = 0; k < 3; ++k) {
        const Rational way = exact(b.state.place[k]) - exact(a.state.place[k]);
        const double n = way.template convert_to<double>() / length;
        CHECK(std::fabs(d(contact.normal[k]) - n) < 1e-5);
        const double point = exact(a.state.place[k]).template convert_to<double>() +
                             n * (r_a + (length - r_a - r_b) / 2);
        CHECK(std::fabs(d(contact.points[0].point[k]) - point) < 2e-5);
      }
    });
  }
  CHECK(seen > 20);
}

TEST_CASE("contacts: of a hit, the change of the momentum") {
  // docs/dynamics.md says how to measure a hit: the last substep does not have its impulse.
  using S = q16_16;
  World<S, 2, Sphere, Obb> world;
  world.add(box_of<S, 2>(0, -1, 4, 1), {.motion = BodyMotion::fixed});
  const auto ball = *world.add(Sphere<S, 2>{at<S, 2>(0, 2.5), num<S>(0.5)}, {.density = S(3)});
  double hardest = 0;
  for (int tick = 0; tick < 60; ++tick) {
    const auto before = world.velocity(ball);
    world.step();
    bool touches = false;
    world.for_each_contact(ball, [&](const auto&) { touches = true; });
    if (!touches) continue;
    const double hit = d(world.mass(ball)) * (d(world.velocity(ball).y) - d(before.y) + 10.0 / 60);
    hardest = std::max(hardest, hit);
  }
  const double mass = 3 * 3.14159265 / 4;
  CHECK(std::fabs(hardest - mass * std::sqrt(2 * 10 * 2)) < 0.06 * mass * std::sqrt(2 * 10 * 2));
}

TEST_CASE("contacts: impulses beyond the scalar are clamped") {
  using S = q16_16;
  World<S, 2, Obb> world(restless<S, 2>());
  world.add(box_of<S, 2>(0, -100, 200, 100), {.motion = BodyMotion::fixed});
  world.add(box_of<S, 2>(0, 100, 100, 100), {.density = S(32000)});
  step(world, 30);
  const auto found = contacts_of(world);
  REQUIRE(found.size() == 1);
  CHECK(found[0].impulse == (S::max)());  // of 53 million
}

TEST_CASE("contacts: parts of compounds and triangles of meshes have their numbers") {
  using S = q16_16;
  // A table with two legs, on a floor of triangles.
  const std::array parts{BodyPart(box_of<S, 3>(0, 1, 1, 0.125)),
                         BodyPart(box_of<S, 3>(-0.75, 0.5, 0.125, 0.5)),
                         BodyPart(box_of<S, 3>(0.75, 0.5, 0.125, 0.5))};
  const auto table = *solid_compound(1, parts);
  const auto triangles = square<S>(4, 8, level);
  const Owned<S> ground{triangles};
  World<S, 3, Obb, Sphere, BodyCompound, BodyMesh> world(restless<S, 3>());
  const auto floor =
      *world.add(BodyMesh<S, 3>{&ground.asset, {}, {}}, {.motion = BodyMotion::fixed});
  const auto id = *world.add(BodyCompound<S, 3>{&table, {}, {}});
  step(world, 30);
  std::array<double, 3> impulse{};
  world.for_each_contact(id, [&](const WorldContact<S, 3>& contact) {
    CHECK(contact.a == floor);
    CHECK(contact.b == id);
    CHECK(contact.part_a == 0);
    REQUIRE((contact.part_b == 1 || contact.part_b == 2));
    impulse[contact.part_b] += d(contact.impulse);
    CHECK(d(contact.normal[1]) > 0.999);
    const auto& own = triangles[contact.triangle];
    for (std::size_t i = 0; i < contact.count; ++i) {
      const auto& point = contact.points[i].point;
      CHECK(std::fabs(d(point.y)) < 0.03);
      const auto within = [&](int k) {
        const std::array corners{d(own.a[k]), d(own.b[k]), d(own.c[k])};
        return d(point[k]) > *std::min_element(corners.begin(), corners.end()) - 0.01 &&
               d(point[k]) < *std::max_element(corners.begin(), corners.end()) + 0.01;
      };
      CHECK(within(0));
      CHECK(within(2));
    }
  });
  const double weight = d(world.mass(id)) * 10 / 240;
  CHECK(std::fabs(impulse[1] + impulse[2] - weight) < 0.02 * weight);
  CHECK(impulse[1] > 0.3 * weight);
  CHECK(impulse[2] > 0.3 * weight);
}

TEST_CASE("contacts: none of sensors, of bodies that do not exist, and of bodies put elsewhere") {
  using S = q16_16;
  World<S, 2, Sphere, Obb> world(restless<S, 2>());
  const auto floor = *world.add(box_of<S, 2>(0, -1, 4, 1), {.motion = BodyMotion::fixed});
  const auto zone =
      *world.add(box_of<S, 2>(0, 0, 2, 2), {.motion = BodyMotion::fixed, .is_sensor = true});
  const auto ball = *world.add(Sphere<S, 2>{at<S, 2>(0, 0.5), num<S>(0.5)});
  step(world, 10);
  int touches = 0;
  world.for_each_touch([&](const TouchEvent&) { ++touches; });
  CHECK(touches == 2);
  REQUIRE(contacts_of(world).size() == 1);
  const auto count_of = [&](const BodyId& id) {
    int count = 0;
    world.for_each_contact(id, [&](const auto&) { ++count; });
    return count;
  };
  CHECK(count_of(floor) == 1);
  CHECK(count_of(ball) == 1);
  CHECK(count_of(zone) == 0);
  CHECK(count_of(no_object) == 0);
  CHECK(count_of({ball.index, ball.generation + 1}) == 0);
  const auto digest_before = digest(world);
  contacts_of(world);
  CHECK(digest(world) == digest_before);
  world.set_position(ball, world.position(ball));
  REQUIRE(contacts_of(world).size() == 1);
  CHECK(contacts_of(world)[0].impulse == S(0));
  world.set_position(ball, at<S, 2>(0, 3));
  CHECK(contacts_of(world).empty());
}

TEST_CASE("contacts: asleep, they keep their impulses") {
  using S = q16_16;
  World<S, 2, Obb> world;
  world.add(box_of<S, 2>(0, -1, 4, 1), {.motion = BodyMotion::fixed});
  const auto box = *world.add(box_of<S, 2>(0, 0.5, 0.5, 0.5));
  step(world, 200);
  REQUIRE(world.is_asleep(box));
  const auto found = contacts_of(world);
  REQUIRE(found.size() == 1);
  CHECK(d(found[0].impulse) > 0.9 * 10 / 240);
  step(world, 100);
  CHECK(contacts_of(world) == found);
  const auto copy = world;  // without the scratch data of steps
  CHECK(contacts_of(copy) == found);
}

}  // namespace detent::test
