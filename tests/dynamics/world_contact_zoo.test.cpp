// SPDX-License-Identifier: MIT
//
// Contacts among bodies of every kind, compared with what the next step finds, and changes of
// filters, materials and sensors.
#include <algorithm>
#include <cstdlib>
#include <utility>
#include <vector>

#include "detent/dynamics/snapshot.hpp"
#include "detent/dynamics/world.hpp"
#include "dynamics/stage.hpp"
#include "dynamics/zoo.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

using S = q16_16;

template <class World>
auto contacts_of(const World& world) {
  std::vector<WorldContact<S, World::dimension>> found;
  world.for_each_contact([&](const auto& contact) { found.push_back(contact); });
  return found;
}

/// A box that sleeps on a floor.
template <int N>
struct Sleeper {
  World<S, N, Obb> world;
  BodyId floor = *world.add(box_of<S, N>(0, -1, 90, 1), {.motion = BodyMotion::fixed});
  BodyId box = *world.add(box_of<S, N>(0, 0.5, 0.5, 0.5));

  explicit Sleeper(const WorldSettings<S, N>& settings = {}) : world(settings) {
    for (int i = 0; i < 200; ++i) world.step();
    REQUIRE(world.is_asleep(box));
  }
};

}  // namespace

TEMPLATE_TEST_CASE("contacts: they are those that the next step finds", "", Dim<2>, Dim<3>) {
  constexpr int N = TestType::value;
  const auto seed = GENERATE(1, 2, 3);
  INFO("seed " << seed);
  Zoo<S, N> zoo(static_cast<std::uint64_t>(seed));
  int seen = 0, touching = 0, of_touching = 0, held = 0;
  for (int round = 0; round < 25; ++round) {
    zoo.live();
    const auto& world = zoo.world;
    const auto found = contacts_of(world);
    const auto& bodies = detail::WorldAccess::bodies(world);

    // A function of the state.
    auto next = world;
    CHECK(contacts_of(next) == found);

    // Those of each body are the same ones.
    std::size_t of_bodies = 0;
    world.for_each([&](const BodyInfo& body) {
      world.for_each_contact(body.id, [&](const WorldContact<S, N>& contact) {
        CHECK((contact.a == body.id || contact.b == body.id));
        ++of_bodies;
      });
    });
    CHECK(of_bodies == 2 * found.size());

    // Of pairs that touch; of those without a sensor nearly all have one.
    std::vector<TouchEvent> touches;
    world.for_each_touch([&](const TouchEvent& touch) { touches.push_back(touch); });
    const auto is_of = [](const WorldContact<S, N>& contact, const TouchEvent& touch) {
      return contact.a == touch.a && contact.b == touch.b && contact.part_a == touch.part_a &&
             contact.part_b == touch.part_b;
    };
    for (const auto& contact : found) {
      CHECK(std::any_of(touches.begin(), touches.end(),
                        [&](const auto& touch) { return is_of(contact, touch); }));
      CHECK_FALSE(world.info(contact.a)->is_sensor);
      CHECK_FALSE(world.info(contact.b)->is_sensor);
    }
    for (const auto& touch : touches) {
      bool is_sensed = false;
      for (const auto& [id, part] : {std::pair(touch.a, touch.part_a), {touch.b, touch.part_b}}) {
        world.visit(id, [&, number = part](const BodyInfo& info, const auto&) {
          is_sensed = is_sensed || (info.part == number && info.is_sensor);
        });
      }
      if (is_sensed) continue;
      ++touching;
      of_touching += std::any_of(found.begin(), found.end(),
                                 [&](const auto& contact) { return is_of(contact, touch); });
    }

    // The next step begins with these: the same pairs, parts, triangles and features.
    next.step();
    const auto& contacts = detail::WorldAccess::contacts(next);
    for (const auto& contact : found) {
      ++seen;
      held += bodies[contact.a.index].is_held() || bodies[contact.b.index].is_held();
      const bool has_two = detail::part_count(bodies[contact.a.index]) != 0 &&
                           detail::part_count(bodies[contact.b.index]) != 0;
      bool is_found = false;
      for (std::size_t i = 0; i < contacts.size(); ++i) {
        const auto& other = contacts[i];
        is_found =
            is_found ||
            (other.a == contact.a.index && other.b == contact.b.index &&
             other.member == (has_two ? contact.part_a : contact.part_a + contact.part_b) &&
             other.part == (has_two ? contact.part_b : contact.triangle) &&
             other.count == contact.count &&
             std::equal(other.feature.begin(), other.feature.begin() + other.count,
                        contact.points.begin(), [](std::uint32_t feature, const auto& point) {
                          return feature == point.feature;
                        }));
      }
      CHECK(is_found);
    }

    // Points of solid bodies are near the surfaces of both.
    for (const auto& contact : found) {
      const auto check_near = [&](const BodyId& id, std::uint32_t part) {
        world.visit(id, [&]<class Shape>(const BodyInfo& info, const Shape& shape) {
          if (info.part != part) return;
          for (std::size_t i = 0; i < contact.count; ++i) {
            const auto& point = contact.points[i];
            const auto reach = nearest_to<S>(abs(point.separation) + num<S>(0.13));
            CHECK(overlaps(shape, Sphere<S, N>{point.point, reach}));
          }
        });
      };
      check_near(contact.a, contact.part_a);
      check_near(contact.b, contact.part_b);
    }
  }
  CHECK(seen > 30);
  CHECK(held > 3);
  CHECK(of_touching > touching * 9 / 10);
}

TEST_CASE("contacts: impulses and gravity are the change of the momentum") {
  // In steps of one substep, the last substep is the whole step.
  constexpr int N = 2;
  WorldSettings<S, N> settings;
  settings.ticks_per_second = 240;
  settings.substeps = 1;
  settings.sleep_speed = settings.hold_distance = {};
  World<S, N, Sphere, Obb> world(settings);
  world.add(box_of<S, N>(0, -1, 9, 1), {.motion = BodyMotion::fixed});
  std::vector<BodyId> ids;
  for (int i = 0; i < 6; ++i) {
    BodyOptions<S, N> options{.density = S(1 + i), .velocity = at<S, N>(1, 0)};
    options.angular_velocity[0] = num<S>(0.5);
    ids.push_back(
        i % 2 == 0 ? *world.add(box_of<S, N>(0.1 * i, 0.5 + i, 0.5, 0.5), options)
                   : *world.add(Sphere<S, N>{at<S, N>(-0.1 * i, 0.5 + i), num<S>(0.5)}, options));
  }
  for (int tick = 0; tick < 300; ++tick) {
    const auto before = world;
    world.step();
    for (const auto& id : ids) {
      Vec<double, N> impulse{};
      impulse.y = -double(world.mass(id)) * 10 / 240;
      double sum = 0;
      world.for_each_contact(id, [&](const WorldContact<S, N>& contact) {
        const double side = contact.b == id ? 1 : -1;
        sum += double(contact.impulse);
        for (int k = 0; k < N; ++k) {
          impulse[k] += side * (double(contact.impulse) * double(contact.normal[k]) +
                                double(contact.friction[k]));
        }
      });
      for (int k = 0; k < N; ++k) {
        const double gained = double(world.mass(id)) *
                              (double(world.velocity(id)[k]) - double(before.velocity(id)[k]));
        // The contacts are those of the next step: their normals have turned by the motion of this one.
        CHECK(std::abs(gained - impulse[k]) < 0.001 + 0.05 * sum);
      }
    }
  }
}

TEMPLATE_TEST_CASE("set_filter: a body falls through what it no longer collides with", "", Dim<2>,
                   Dim<3>) {
  constexpr int N = TestType::value;
  World<S, N, Obb> world;
  const auto floor = *world.add(box_of<S, N>(0, -1, 9, 1), {.motion = BodyMotion::fixed});
  const auto box = *world.add(box_of<S, N>(0, 0.5, 0.5, 0.5));
  const auto on_top = *world.add(box_of<S, N>(0, 1.5, 0.5, 0.5));
  const auto step = [&](int ticks) {
    for (int i = 0; i < ticks; ++i) world.step();
  };
  step(200);
  REQUIRE(world.is_asleep(on_top));
  CHECK(world.set_filter(box, 2, 0xfffffffeu));
  CHECK_FALSE(world.is_asleep(box));
  CHECK_FALSE(world.is_asleep(on_top));
  CHECK(world.info(box)->layers == 2);
  CHECK(world.info(box)->collides_with == 0xfffffffeu);
  CHECK(contacts_of(world).size() == 2);  // until the next step
  step(1);
  CHECK(contacts_of(world).empty());
  REQUIRE(world.event_count() == 2);
  CHECK(world.event(0) == TouchEvent{floor, box, false});
  CHECK(world.event(1) == TouchEvent{box, on_top, false});
  step(60);
  CHECK(world.position(box).y < S(-2));
  CHECK(abs(world.position(on_top).y - num<S>(0.5)) < num<S>(0.02));
  CHECK_FALSE(world.set_filter(no_object, 1, 1));
  CHECK_FALSE(world.set_filter({box.index, box.generation + 1}, 1, 1));

  // The other way: what it was in pushes it out.
  world.set_position(box, at<S, N>(0, -0.25));
  CHECK(world.set_filter(box, 1, ~0u));
  step(120);
  CHECK(world.position(box).y > num<S>(0.4));
}

TEMPLATE_TEST_CASE("set_friction: a sleeping box begins to slide on a slope", "", Dim<2>, Dim<3>) {
  constexpr int N = TestType::value;
  const bool of_floor = GENERATE(false, true);
  WorldSettings<S, N> settings;
  settings.gravity.x = S(3);
  Sleeper<N> sleeper(settings);
  auto& world = sleeper.world;
  const auto floor = sleeper.floor, box = sleeper.box;
  const auto x = world.position(box).x;
  CHECK(world.set_friction(of_floor ? floor : box, S(0)));
  CHECK_FALSE(world.is_asleep(box));
  for (int i = 0; i < 60; ++i) world.step();
  CHECK(world.position(box).x > x + num<S>(1.4));
  CHECK_FALSE(world.set_friction(no_object, S(0)));
}

TEMPLATE_TEST_CASE("set_restitution: a ball bounces from then on", "", Dim<2>, Dim<3>) {
  constexpr int N = TestType::value;
  World<S, N, Sphere, Obb> world;
  world.add(box_of<S, N>(0, -1, 9, 1), {.motion = BodyMotion::fixed});
  const auto ball = *world.add(Sphere<S, N>{at<S, N>(0, 2), num<S>(0.5)});
  CHECK(world.set_restitution(ball, num<S>(0.75)));
  S fastest{};
  for (int i = 0; i < 60; ++i) {
    world.step();
    fastest = (max)(fastest, world.velocity(ball).y);
  }
  CHECK(fastest > num<S>(3.5));  // of 5.4 when it lands
  CHECK_FALSE(world.set_restitution(no_object, S(0)));
}

TEMPLATE_TEST_CASE("set_sensor: a floor lets bodies through and reports them, then holds them", "",
                   Dim<2>, Dim<3>) {
  constexpr int N = TestType::value;
  Sleeper<N> sleeper;
  auto& world = sleeper.world;
  const auto floor = sleeper.floor, box = sleeper.box;
  CHECK(world.set_sensor(floor, true));
  CHECK(world.info(floor)->is_sensor);
  for (int i = 0; i < 10; ++i) world.step();
  CHECK(world.position(box).y < num<S>(0.4));
  int touches = 0;
  world.for_each_touch([&](const TouchEvent&) { ++touches; });
  CHECK(touches == 1);
  CHECK(contacts_of(world).empty());
  CHECK(world.set_sensor(floor, false));
  for (int i = 0; i < 120; ++i) world.step();
  CHECK(abs(world.position(box).y - num<S>(0.5)) < num<S>(0.02));
  CHECK_FALSE(world.set_sensor(no_object, true));
}

TEMPLATE_TEST_CASE("set_gravity_scale, set_damping, set_locked, set_fast, set_user: as if added so",
                   "", Dim<2>, Dim<3>) {
  constexpr int N = TestType::value;
  BodyOptions<S, N> options{.velocity = at<S, N>(3, 1)};
  options.angular_velocity[0] = num<S>(0.5);
  World<S, N, Sphere, Obb> world;
  world.add(box_of<S, N>(0, -1, 90, 1), {.motion = BodyMotion::fixed});
  auto added = world;
  const auto box = box_of<S, N>(0, 1, 0.5, 0.25);
  const auto id = *world.add(box, options);
  options.gravity_scale = num<S>(0.25);
  options.linear_damping = num<S>(0.5);
  options.angular_damping = S(2);
  options.locked = AxisLock::x;
  options.is_fast = true;
  options.user = 7;
  REQUIRE(*added.add(box, options) == id);
  CHECK(digest(world) != digest(added));
  CHECK(world.set_gravity_scale(id, options.gravity_scale));
  CHECK(world.set_damping(id, options.linear_damping, options.angular_damping));
  CHECK(world.set_locked(id, options.locked));
  CHECK(world.set_fast(id, options.is_fast));
  CHECK(world.set_user(id, options.user));
  CHECK(world.info(id)->user == 7);
  for (int i = 0; i < 120; ++i) {
    CHECK(digest(world) == digest(added));
    world.step();
    added.step();
  }
  CHECK(world.position(id).x == 0);
  CHECK_FALSE(world.set_gravity_scale(no_object, S(0)));
  CHECK_FALSE(world.set_damping(no_object, S(0), S(0)));
  CHECK_FALSE(world.set_locked(no_object, 0));
  CHECK_FALSE(world.set_fast(no_object, true));
  CHECK_FALSE(world.set_user(no_object, 0));
}

TEMPLATE_TEST_CASE(
    "set_gravity_scale, set_damping, set_locked, set_fast: wake a body, but set_user does not", "",
    Dim<2>, Dim<3>) {
  constexpr int N = TestType::value;
  Sleeper<N> sleeper;
  auto& world = sleeper.world;
  const auto floor = sleeper.floor, box = sleeper.box;
  const auto asleep = world;
  CHECK(world.set_user(box, 1));
  CHECK(world.is_asleep(box));
  const auto wakes = [&](const auto& change) {
    auto changed = asleep;
    CHECK(change(changed));
    return !changed.is_asleep(box);
  };
  CHECK(wakes([&](auto& w) { return w.set_gravity_scale(box, S(2)); }));
  CHECK(wakes([&](auto& w) { return w.set_damping(box, S(1), S(1)); }));
  CHECK(wakes([&](auto& w) { return w.set_locked(box, AxisLock::turn); }));
  CHECK(wakes([&](auto& w) { return w.set_fast(box, true); }));

  // Without gravity it rises with the least push.
  world.set_gravity_scale(box, S(0));
  world.apply_impulse(box, at<S, N>(0, 1));
  for (int i = 0; i < 60; ++i) world.step();
  CHECK(world.position(box).y > num<S>(1.4));

  // The word of a fixed body belongs to the level.
  std::vector<std::byte> bytes(snapshot(asleep, std::span<std::byte>()));
  snapshot(asleep, bytes);
  CHECK(restore(world, bytes) == Restored::yes);
  CHECK(world.info(box)->user == 0);
  world.set_user(floor, 1);
  CHECK(restore(world, bytes) == Restored::other_fixed_part);
}

TEMPLATE_TEST_CASE("set_gravity: as if made so, wakes all bodies, and is restored", "", Dim<2>,
                   Dim<3>) {
  constexpr int N = TestType::value;
  const auto up = at<S, N>(0.5, 4);
  World<S, N, Sphere, Obb> made(WorldSettings<S, N>{.gravity = up}), changed;
  changed.set_gravity(up);
  CHECK(changed.settings().gravity == up);
  for (auto* world : {&made, &changed}) {
    world->add(box_of<S, N>(0, -1, 90, 1), {.motion = BodyMotion::fixed});
    world->add(box_of<S, N>(0, 1, 0.5, 0.25));
    world->add(box_of<S, N>(3, 1, 0.5, 0.25), {.gravity_scale = num<S>(-0.5)});
  }
  for (int i = 0; i < 60; ++i) {
    CHECK(digest(made) == digest(changed));
    made.step();
    changed.step();
  }

  Sleeper<N> sleeper;
  auto& world = sleeper.world;
  std::vector<std::byte> bytes(snapshot(world, std::span<std::byte>()));
  snapshot(world, bytes);
  const auto asleep = world;
  world.set_gravity(at<S, N>(0, 10));
  CHECK_FALSE(world.is_asleep(sleeper.box));
  CHECK(digest(world) != digest(asleep));
  for (int i = 0; i < 60; ++i) world.step();
  CHECK(world.position(sleeper.box).y > num<S>(4));
  CHECK(restore(world, bytes) == Restored::yes);
  CHECK(digest(world) == digest(asleep));
  CHECK(world.settings().gravity == asleep.settings().gravity);
  CHECK(world.is_asleep(sleeper.box));
}

TEMPLATE_TEST_CASE("setters of bodies: the state of snapshots, copies and digests", "", Dim<2>,
                   Dim<3>) {
  constexpr int N = TestType::value;
  const auto seed = GENERATE(1, 2);
  INFO("seed " << seed);
  Zoo<S, N> zoo(static_cast<std::uint64_t>(seed));
  auto& world = zoo.world;
  for (int round = 0; round < 12; ++round) {
    zoo.live();
    const auto id = zoo.any();
    const bool is_fixed_body = world.info(id)->motion == BodyMotion::fixed;
    const auto before = digest(world);
    const auto saved = world;
    world.set_filter(id, 1 + static_cast<std::uint32_t>(zoo.random.below(3)), 5);
    world.set_friction(id, num<S>(0.375));
    world.set_restitution(id, num<S>(0.25));
    world.set_sensor(id, zoo.random.one_in(4));
    world.set_gravity_scale(id, num<S>(0.5));
    world.set_damping(id, num<S>(0.125), num<S>(0.25));
    world.set_locked(id, static_cast<std::uint8_t>(zoo.random.below(64)));
    world.set_fast(id, zoo.random.one_in(4));
    world.set_user(id, zoo.random.next());
    world.set_gravity(at<S, N>(round, -8));
    CHECK((digest_of(world, id) != digest_of(saved, id)));
    if (!is_fixed_body) CHECK(digest(world) != before);

    // A restored world and a copy go on like this one.
    auto copy = world, restored = world;
    std::vector<std::byte> bytes(snapshot(world, std::span<std::byte>()));
    snapshot(world, bytes);
    restored.step();
    REQUIRE(restore(restored, bytes, zoo.hulls(), zoo.compounds()) == Restored::yes);
    for (int tick = 0; tick < 5; ++tick) {
      copy.step();
      restored.step();
      world.step();
      REQUIRE(digest(copy) == digest(world));
      REQUIRE(digest(restored) == digest(world));
      REQUIRE(contacts_of(copy) == contacts_of(world));
    }
    // A rollback also restores what was set.
    world = saved;
    CHECK(digest(world) == before);
    CHECK(world.info(id) == saved.info(id));
  }
}

}  // namespace detent::test
