// SPDX-License-Identifier: MIT
#include "detent/dynamics/fields.hpp"

#include <string>
#include <vector>

#include "detent/scene/sync_test.hpp"
#include "dynamics/stage.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

using S = q16_16;
using Balls = World<S, 2, Sphere, Obb>;

/// Three balls on a round floor after landing.
Balls settled(int ticks = 90) {
  Balls world;
  add_round_ground(world);
  for (int i = 0; i < 3; ++i) add_ball(world, 2.1 * i - 2.1, 2.5);
  for (int i = 0; i < ticks; ++i) world.step();
  return world;
}

std::vector<std::string> names(const Balls& a, const Balls& b, std::size_t most = 16) {
  std::vector<std::string> result;
  const auto count = diff(
      a, b,
      [&](const FieldDifference& difference) {
        result.emplace_back(difference.field.view());
        CHECK(difference.object);
      },
      most);
  CHECK(count == result.size());
  return result;
}
using Names = std::vector<std::string>;

auto& body(Balls& world, std::size_t i) { return detail::WorldAccess::bodies(world)[i]; }

}  // namespace

TEST_CASE("fields: equal worlds have no differing field") {
  const auto world = settled();
  CHECK(names(world, settled()).empty());
  CHECK_FALSE(diff(world, world));
}

TEST_CASE("fields: a difference names the body and the field") {
  const auto world = settled();
  auto other = world;
  other.set_velocity({2, 3}, {S(1), {}});
  const auto first = diff(world, other);
  REQUIRE(first);
  CHECK(first->object == BodyId{2, 3});
  CHECK(std::string(first->field.view()) == "body 2:3 (sphere) velocity.x");
  body(other, 1).state.orientation.y = {};
  body(other, 1).user = 1;
  body(other, 3).friction = {};
  CHECK(names(world, other) == Names{"body 1:2 (sphere) orientation[1]", "body 1:2 (sphere) user",
                                     "body 2:3 (sphere) velocity.x", "body 2:3 (sphere) sleeps",
                                     "body 2:3 (sphere) quiet", "body 3:4 (sphere) friction"});
  CHECK(names(world, other, 1) == Names{"body 1:2 (sphere) orientation[1]"});
}

TEST_CASE("fields: gravity comes first") {
  const auto world = settled();
  auto other = world;
  other.set_gravity({S(1), S(-10)});
  const auto first = diff(world, other);
  REQUIRE(first);
  CHECK_FALSE(first->object);
  CHECK(std::string(first->field.view()) == "gravity.x");
}

TEST_CASE("fields: a contact is named after both its bodies") {
  const auto world = settled();
  auto other = world;
  auto& contacts = detail::WorldAccess::contacts(other);
  REQUIRE(contacts.size() >= 3);
  REQUIRE(contacts[1].b == 2);
  contacts[1].pressure[0] = typename detail::Formats<S>::Impulse{};
  CHECK(names(world, other) == Names{"contact 0:1 2:3 point 0 pressure"});
  contacts[1].touches = false;
  contacts.erase(contacts.begin());
  CHECK(names(world, other) ==
        Names{"contact 0:1 1:2", "contact 0:1 2:3 touches", "contact 0:1 2:3 point 0 pressure"});
}

TEST_CASE("fields: a body that only one world has is one difference") {
  const auto world = settled(1);
  auto other = world;
  REQUIRE(other.remove({2, 3}));
  CHECK(names(world, other) == Names{"body 2:3"});
  CHECK(names(other, world) == Names{"body 2:3"});
  REQUIRE(other.put({2, 3}, Obb<S, 2>{{S(40), S(9)}, {S(1), S(1)}, {}}));
  CHECK(names(world, other, 1) == Names{"body 2:3 type"});
}

TEST_CASE("fields: every change of a body or contact that changes the digest is named") {
  const auto world = settled(20);
  auto other = world;
  const auto is_named = [&](auto&& change) {
    other = world;
    change(other);
    CHECK(digest(other) != digest(world));
    CHECK(detail::WorldDigest(other).all() != detail::WorldDigest(world).all());
    CHECK(diff(world, other));
  };
  is_named([](Balls& w) { body(w, 1).quiet ^= 1; });
  is_named([](Balls& w) { body(w, 1).sleeps = !body(w, 1).sleeps; });
  is_named([](Balls& w) { body(w, 1).motion = BodyMotion::kinematic; });
  is_named([](Balls& w) { body(w, 1).layers ^= 1; });
  is_named([](Balls& w) { body(w, 1).collides_with ^= 1; });
  is_named([](Balls& w) { body(w, 1).density = S(2); });
  is_named([](Balls& w) { body(w, 1).restitution = S(2); });
  is_named([](Balls& w) { body(w, 1).linear_damping = S(2); });
  is_named([](Balls& w) { body(w, 1).angular_damping = S(2); });
  is_named([](Balls& w) { body(w, 1).state.place.y = {}; });
  is_named([](Balls& w) { body(w, 1).state.spin[0] = detail::Formats<S>::Spin::from_raw(1); });
  is_named([](Balls& w) {
    body(w, 1).shape = detail::OneOf<Sphere<S, 2>, Obb<S, 2>>(Sphere<S, 2>{{}, S(2)});
  });
}

TEST_CASE("fields: a changed fixed body is named although the world's digest omits it") {
  const auto world = settled(1);
  auto other = world;
  body(other, 0).state.place.x = detail::Formats<S>::Place(S(1));
  CHECK(digest(other) == digest(world));
  CHECK(detail::WorldDigest(other).all() != detail::WorldDigest(world).all());
  CHECK(names(world, other) == Names{"body 0:1 (sphere) place.x"});
}

TEST_CASE("fields: SyncTest names the body that depends on state outside the world") {
  auto world = settled(5);
  SyncTest<Balls, int> test(4);
  int gust = 0;
  std::optional<Desync> desync;
  for (int tick = 0; tick < 6 && !desync; ++tick) {
    desync = test.step(world, 0, [&](Balls& w, int) {
      if (++gust == 9) w.set_velocity({3, 4}, {S(2), {}});
      w.step();
    });
  }
  REQUIRE(desync);
  CHECK(desync->object == BodyId{3, 4});
  CHECK(std::string(desync->field.view()).starts_with("body 3:4 (sphere) place."));
}

TEST_CASE("fields: a copied world without the caches of its last step continues identically") {
  auto world = settled(20);
  auto copy = world;
  Balls assigned;
  assigned = world;
  for (int i = 0; i < 60; ++i) {
    world.step();
    copy.step();
    assigned.step();
    REQUIRE(digest(copy) == digest(world));
    REQUIRE(digest(assigned) == digest(world));
    REQUIRE(copy.event_count() == world.event_count());
  }
}

}  // namespace detent::test
