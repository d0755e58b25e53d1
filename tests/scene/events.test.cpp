// SPDX-License-Identifier: MIT
#include "detent/scene/events.hpp"

#include <array>
#include <set>
#include <vector>

#include "detent/scene/sync_test.hpp"
#include "support/catch.hpp"

using namespace detent;
using detent::test::Random;
using S = q16_16;
using Vec3 = Vec<S, 3>;
using Ball = Sphere<S, 3>;
using Balls = Scene<S, 3, Sphere, Obb>;
using FewBalls = BoundedScene<Bounded<16>, S, 3, Sphere, Obb>;

namespace {

constexpr ObjectId first{0, 1}, second{1, 2}, third{2, 3};
using Pairs = std::vector<Overlap>;

Pairs list(std::span<const Overlap> pairs) { return {pairs.begin(), pairs.end()}; }

constexpr bool starts_with_events() {
  BoundedOverlapEvents<2> events;
  const std::array pairs{Overlap{first, second}};
  const bool fits = events.update(pairs);
  return fits && events.began().size() == 1 && events.stayed().empty() && events.ended().empty() &&
         events.began()[0] == pairs[0];
}
static_assert(starts_with_events());
static_assert(RollbackWorld<OverlapEvents> && RollbackWorld<BoundedOverlapEvents<3>>);

/// A world with its events.
struct Game {
  Balls scene;
  OverlapEvents events;
};
template <class F>
void for_each_field(const Game& game, const F& f) {
  f("scene", game.scene);
  f("events", game.events);
}
struct FewGame {
  FewBalls scene;
  BoundedOverlapEvents<8> events;
};
template <class F>
void for_each_field(const FewGame& game, const F& f) {
  f("scene", game.scene);
  f("events", game.events);
}

Pairs pairs_of(const Balls& scene) { return scene.overlaps(); }
Pairs pairs_of(const FewBalls& scene) {
  std::array<Overlap, 120> room;
  const auto count = scene.overlaps(room);
  return {room.begin(), room.begin() + static_cast<std::ptrdiff_t>(count)};
}

Vec3 any_point(Random& random, int low, int high) {
  const auto part = [&] {
    return S::from_raw(static_cast<std::int32_t>(random.between(low * 65536, high * 65536)));
  };
  return {part(), part(), part()};
}

/// Adds, removes and moves a few balls.
template <class Scene>
void stir(Scene& scene, std::uint64_t seed) {
  Random random(seed);
  std::vector<ObjectId> ids;
  scene.for_each([&](const ObjectInfo& info, const auto&) { ids.push_back(info.id); });
  for (const auto& id : ids) {
    if (random.one_in(3)) scene.move(id, any_point(random, -1, 1));
    if (random.one_in(16)) scene.remove(id);
  }
  if (ids.size() < 10) scene.add(Ball{any_point(random, 0, 4), S(1)});
}

}  // namespace

TEST_CASE("overlap events: a pair begins, stays and ends") {
  OverlapEvents events;
  Balls scene;
  const auto a = *scene.add(Ball{{}, S(1)}), b = *scene.add(Ball{{S(5), {}, {}}, S(1)});
  const Pairs pair{{a, b}}, none;
  const auto is = [&](const Pairs& began, const Pairs& stayed, const Pairs& ended) {
    return list(events.began()) == began && list(events.stayed()) == stayed &&
           list(events.ended()) == ended;
  };
  CHECK(events.update(scene.overlaps()));
  CHECK(is(none, none, none));
  scene.move(b, Vec3{S(-4), {}, {}});
  CHECK(events.update(scene.overlaps()));
  CHECK(is(pair, none, none));
  CHECK(events.update(scene.overlaps()));
  CHECK(is(none, pair, none));
  CHECK(list(events.now()) == pair);
  scene.move(b, Vec3{S(4), {}, {}});
  CHECK(events.update(scene.overlaps()));
  CHECK(is(none, none, pair));
  CHECK(events.update(scene.overlaps()));
  CHECK(is(none, none, none));
}

TEST_CASE("overlap events: removing an object ends its pairs, and its successor begins new ones") {
  OverlapEvents events;
  Balls scene;
  const auto a = *scene.add(Ball{{}, S(1)}), b = *scene.add(Ball{{}, S(1)});
  CHECK(events.update(scene.overlaps()));
  scene.remove(b);
  const auto c = *scene.add(Ball{{}, S(1)});
  REQUIRE((c.index == b.index && c != b));
  CHECK(events.update(scene.overlaps()));
  CHECK(list(events.ended()) == Pairs{{a, b}});
  CHECK(list(events.began()) == Pairs{{a, c}});
  CHECK(events.stayed().empty());
}

TEST_CASE("overlap events: without room, the first pairs are kept") {
  BoundedOverlapEvents<2> events;
  const Pairs all{{first, second}, {first, third}, {second, third}};
  CHECK_FALSE(events.update(all));
  CHECK(list(events.began()) == Pairs{all[0], all[1]});
  CHECK(events.update(Pairs{all[2]}));
  CHECK(list(events.began()) == Pairs{all[2]});
  CHECK(list(events.ended()) == Pairs{all[0], all[1]});
}

TEST_CASE("overlap events: are the differences between the pairs of two frames") {
  Random random(0xe7e);
  INFO(random);
  Balls scene;
  OverlapEvents events;
  std::set<Overlap> before;
  std::size_t began = 0, stayed = 0, ended = 0;
  for (int frame = 0; frame < 500; ++frame) {
    stir(scene, random.next());
    const auto pairs = scene.overlaps();
    REQUIRE(events.update(pairs));
    const std::set<Overlap> now(pairs.begin(), pairs.end());
    Pairs only_now, both, only_before;
    for (const auto& pair : now) (before.count(pair) != 0 ? both : only_now).push_back(pair);
    for (const auto& pair : before) {
      if (now.count(pair) == 0) only_before.push_back(pair);
    }
    REQUIRE(list(events.began()) == only_now);
    REQUIRE(list(events.stayed()) == both);
    REQUIRE(list(events.ended()) == only_before);
    // Recomputed from the pairs of the two frames.
    OverlapEvents again;
    again.update(Pairs(before.begin(), before.end()));
    again.update(pairs);
    REQUIRE(again == events);
    before = now;
    began += only_now.size();
    stayed += both.size();
    ended += only_before.size();
  }
  CHECK((began > 100 && stayed > 100 && ended > 100));
}

TEMPLATE_TEST_CASE("overlap events: a rollback reproduces them", "", Game, FewGame) {
  Random random(0x5a7e);
  INFO(random);
  TestType game;
  SyncTest<TestType, std::uint64_t> test(8);
  std::size_t events = 0;
  for (int frame = 0; frame < 300; ++frame) {
    const auto desync = test.step(game, random.next(), [](TestType& world, std::uint64_t input) {
      stir(world.scene, input);
      world.events.update(pairs_of(world.scene));
    });
    REQUIRE_FALSE(desync);
    events += game.events.began().size() + game.events.ended().size();
  }
  CHECK(events > 100);
}

TEST_CASE("overlap events: kept outside the world they change in a rollback, which is detected") {
  Game game;
  game.scene.add(Ball{{}, S(1)});
  game.scene.add(Ball{{}, S(1)});
  OverlapEvents outside;  // deliberately wrong
  SyncTest<Game, int> test(4);
  const auto desync = test.step(game, 0, [&](Game& world, int) {
    outside.update(world.scene.overlaps());
    world.events = outside;
  });
  REQUIRE(desync);
  CHECK(desync->field.view() == "events.began.size");
}
