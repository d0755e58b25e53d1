// SPDX-License-Identifier: MIT
//
// Contacts among bodies of every kind, compared with what the next step finds, and changes of
// filters, materials and sensors.
#include <tuple>
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
    std::vector<std::tuple<BodyId, BodyId, std::uint32_t, std::uint32_t, std::uint32_t>> keys;
    const auto& contacts = detail::WorldAccess::contacts(next);
    for (const auto& contact : found) {
      ++seen;
      held += bodies[contact.a.index].is_held() || bodies[contact.b.index].is_held();
      const bool has_two = detail::part_count(bodies[contact.a.index]) != 0 &&
                           detail::part_count(bodies[contact.b.index]) != 0;
      bool is_found = false;
      for (std::size_t i = 0; i < contacts.size(); ++i) {
        const auto& other = contacts[i];
        is_found = is_found ||
                   (other.a == contact.a.index && other.b == contact.b.index &&
                    other.member == (has_two ? contact.part_a : contact.part_a + contact.part_b) &&
                    other.part == (has_two ? contact.part_b : contact.triangle) &&
                    other.count == contact.count &&
                    std::equal(other.feature.begin(), other.feature.begin() + other.count,
                               contact.points.begin(),
                               [](std::uint32_t feature, const auto& point) {
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
            const auto away = distance(shape, Sphere<S, N>{point.point, S(0)});
            CHECK(away <= abs(point.separation) + num<S>(0.13));
          }
        });
      };
      check_near(contact.a, contact.part_a);
      check_near(contact.b, contact.part_b);
    }
  }
  CHECK(seen > 100);
  CHECK(held > 10);
  CHECK(of_touching > touching * 9 / 10);
}

TEMPLATE_TEST_CASE("contacts: impulses and gravity are the change of the momentum", "", Dim<2>,
                   Dim<3>) {
  // In steps of one substep without damping and twist, the last substep is the whole step.
  constexpr int N = TestType::value;
  WorldSettings<S, N> settings;
  settings.ticks_per_second = 240;
  settings.substeps = 1;
  settings.sleep_speed = {};
  World<S, N, Sphere, Obb> world(settings);
  world.add(box_of<S, N>(0, -1, 9, 1), {.motion = BodyMotion::fixed});
  std::vector<BodyId> ids;
  for (int i = 0; i < 6; ++i) {
    BodyOptions<S, N> options{.density = S(1 + i), .velocity = at<S, N>(1, 0)};
    options.angular_velocity[0] = num<S>(0.5);
    ids.push_back(i % 2 == 0 ? *world.add(box_of<S, N>(0.1 * i, 0.5 + i, 0.5, 0.5), options)
                             : *world.add(Sphere<S, N>{at<S, N>(-0.1 * i, 0.5 + i), num<S>(0.5)},
                                          options));
  }
  for (int tick = 0; tick < 300; ++tick) {
    auto before = world;
    world.step();
    for (const auto& id : ids) {
      Vec<double, N> impulse{};
      impulse.y = -double(world.mass(id)) * 10 / 240;
      world.for_each_contact(id, [&](const WorldContact<S, N>& contact) {
        const double side = contact.b == id ? 1 : -1;
        for (int k = 0; k < N; ++k) {
          impulse[k] += side * (double(contact.impulse) * double(contact.normal[k]) +
                                double(contact.friction[k]));
        }
      });
      for (int k = 0; k < N; ++k) {
        const double gained = double(world.mass(id)) *
                              (double(world.velocity(id)[k]) - double(before.velocity(id)[k]));
        // The normal has turned by the motion of the step.
        CHECK(std::abs(gained - impulse[k]) < 0.002 + 0.01 * std::abs(impulse[k]));
      }
    }
  }
}

}  // namespace detent::test
