// SPDX-License-Identifier: MIT
#include "detent/scene/sync_test.hpp"

#include <array>
#include <string>
#include <vector>

#include "support/catch.hpp"

using namespace detent;
using S = q16_16;
using Vec3 = Vec<S, 3>;
using Ball = Sphere<S, 3>;
using Balls = Scene<S, 3, Sphere, Obb>;
using FewBalls = BoundedScene<Bounded<8, 2>, S, 3, Sphere, Obb>;

namespace {

Vec3 at(int x, int y, int z) { return {S(x), S(y), S(z)}; }

enum class Mood : std::uint8_t { calm, angry };

/// A scene and the other state of a game.
template <class Arena>
struct Game {
  Arena scene;
  std::array<Vec3, 2> velocity{};
  std::vector<int> score{0, 0};
  std::array<std::array<Mood, 2>, 2> mood{};
};
template <class Arena, class F>
void for_each_field(const Game<Arena>& game, const F& f) {
  f("scene", game.scene);
  f("velocity", game.velocity);
  f("score", game.score);
  f("mood", game.mood);
}

static_assert(RollbackWorld<Balls> && RollbackWorld<FewBalls> && RollbackWorld<Game<FewBalls>> &&
              RollbackWorld<int> && RollbackWorld<std::vector<Vec3>>);
struct Nameless {
  Balls scene;
};
static_assert(!RollbackWorld<Nameless> && !RollbackWorld<std::vector<Nameless>>);

template <class Arena>
Arena two_balls() {
  Arena scene;
  scene.add(Ball{at(0, 0, 0), S(1)});
  scene.add(Ball{at(9, 0, 0), S(1)});
  return scene;
}

template <class Arena>
void push(Arena& scene, int input) {
  scene.move({0, 1}, at(input, 0, 0));
  if (input == 3) scene.add(Ball{at(1, 2, 3), S(1)});
}

/// The desync of a frame that is first simulated by `first`, then by `second`.
template <class World, class First, class Second>
Desync parted(World world, const First& first, const Second& second) {
  SyncTest<World, int> test(3);
  int calls = 0;
  const auto desync = test.step(world, 0, [&](World& w, int) {
    if (calls++ == 0) {
      first(w);
    } else {
      second(w);
    }
  });
  REQUIRE(desync);
  CHECK(desync->frame == 0);
  return *desync;
}
constexpr auto nothing = [](auto&) {};

std::string field(const Desync& desync) { return std::string(desync.field.view()); }

}  // namespace

TEMPLATE_TEST_CASE("sync test: a simulation of only the world and the inputs never desyncs", "",
                   Balls, FewBalls) {
  auto scene = two_balls<TestType>(), plain = scene, other = scene;
  SyncTest<TestType, int> test(5);
  SyncTest<TestType, int, 5> bounded;
  for (int frame = 0; frame < 30; ++frame) {
    CHECK_FALSE(test.step(scene, frame % 4, push<TestType>));
    CHECK_FALSE(bounded.step(other, frame % 4, push<TestType>));
    push(plain, frame % 4);
    CHECK(digest(scene) == digest(plain));
    CHECK(digest(other) == digest(plain));
  }
}

TEMPLATE_TEST_CASE("sync test: names the first frame, object and field changed by a call counter",
                   "", Balls, FewBalls) {
  auto scene = two_balls<TestType>();
  SyncTest<TestType, int, 5> test;
  int calls = 0;
  const auto with_a_secret = [&](TestType& balls, int input) {
    push(balls, input);
    if (++calls == 20) balls.move({1, 2}, at(0, 1, 0));
  };
  std::optional<Desync> desync;
  std::uint64_t frame = 0;
  for (; !desync; ++frame) desync = test.step(scene, 1, with_a_secret);
  // Frame 0 makes 2 calls, frame 1 makes 3, frame 4 makes calls 15 to 20; call 20 repeats it.
  CHECK(frame == 5);
  CHECK(desync->frame == 4);
  CHECK(desync->object == ObjectId{1, 2});
  CHECK(field(*desync) == "object 1:2 (sphere) center.y");
}

TEST_CASE("sync test: names a frame inside the window that desyncs later") {
  Balls scene = two_balls<Balls>();
  SyncTest<Balls, int> test(4);
  int calls = 0;
  const auto late = [&](Balls& balls, int input) {
    push(balls, input);
    if (++calls == 17) balls.set_user({1, 2}, 5);  // call 17 simulates frame 2 again
  };
  for (int i = 0; i < 4; ++i) REQUIRE_FALSE(test.step(scene, 1, late));
  const auto desync = test.step(scene, 1, late);
  REQUIRE(desync);
  CHECK(desync->frame == 2);
  CHECK(field(*desync) == "object 1:2 (sphere) user");
}

TEST_CASE("sync test: names everything in a scene that can desync") {
  auto scene = two_balls<Balls>();
  const auto arm = scene.add_frame({.translation = at(1, 0, 0)}).value_or(no_frame);
  scene.add(Obb<S, 3>{at(0, 0, 0), at(1, 1, 1), {}}, {.frame = arm});
  const ObjectId ball{1, 2}, box{2, 4};
  const auto again = [&](const auto& change) { return parted(scene, nothing, change); };

  auto desync = again([&](Balls& s) { s.remove(ball); });
  CHECK(desync.object == ball);
  CHECK(field(desync) == "object 1:2");
  desync = again([](Balls& s) { s.add(Ball{}); });
  CHECK(desync.object == ObjectId{3, 5});
  CHECK(field(desync) == "object 3:5");
  desync = again([&](Balls& s) { s.remove(ball), s.add_as({1, 3}, Ball{}); });
  CHECK(field(desync) == "object 1:2");
  desync = again([&](Balls& s) { s.replace(ball, Obb<S, 3>{}); });
  CHECK(field(desync) == "object 1:2 type");
  desync = again([&](Balls& s) { s.set_layers(ball, 8); });
  CHECK(field(desync) == "object 1:2 (sphere) layers");
  desync = again([&](Balls& s) { s.replace(ball, Ball{at(9, 0, 0), S(2)}); });
  CHECK(field(desync) == "object 1:2 (sphere) radius");
  desync = again([&](Balls& s) {
    s.replace_local(box, Obb<S, 3>{at(0, 0, 0), at(1, 1, 1),
                                   Rotation<S, 3>::from_euler({}, {}, Angle<S>::turn(1, 4))});
  });
  CHECK(desync.object == box);
  CHECK(field(desync) == "object 2:4 (obb) axis 0.x");
  desync = again([&](Balls& s) { s.move_frame(arm, {.translation = at(1, 5, 0)}); });
  CHECK_FALSE(desync.object);
  CHECK(field(desync) == "frame 0:3 translation.y");
  desync = again([&](Balls& s) { s.add_frame({}); });
  CHECK(field(desync) == "frame 1:5");
  desync = again([&](Balls& s) { s.remove(s.add(Ball{}).value_or(no_object)); });
  CHECK_FALSE(desync.object);
  CHECK(field(desync) == "next generation");
}

TEMPLATE_TEST_CASE("sync test: names the fields of a caller's world", "", Game<Balls>,
                   Game<FewBalls>) {
  TestType game;
  game.scene = two_balls<decltype(game.scene)>();
  const auto again = [&](const auto& change) { return parted(game, nothing, change); };
  auto desync = again([](TestType& g) { g.velocity[1].z = S(1); });
  CHECK_FALSE(desync.object);
  CHECK(field(desync) == "velocity[1].z");
  CHECK(field(again([](TestType& g) { g.score[0] = 3; })) == "score[0]");
  CHECK(field(again([](TestType& g) { g.score.push_back(0); })) == "score.size");
  CHECK(field(again([](TestType& g) { g.mood[1][0] = Mood::angry; })) == "mood[1][0]");
  desync = again([](TestType& g) { g.scene.move({0, 1}, at(0, 0, 1)), g.score[0] = 3; });
  CHECK(desync.object == ObjectId{0, 1});
  CHECK(field(desync) == "scene object 0:1 (sphere) center.z");
  desync = again([](TestType& g) { g.scene.remove({0, 1}), g.scene.add(Ball{}), g.score[0] = 3; });
  CHECK(field(desync) == "scene object 0:1");
}

TEST_CASE("sync test: names a fixed object that a frame changes, because no snapshot restores it") {
  Balls scene = two_balls<Balls>();
  const auto wall =
      scene.add(Ball{at(0, 0, 0), S(2)}, {.motion = Motion::fixed}).value_or(no_object);
  SyncTest<Balls, int> test(3);
  const auto simulate = [&](Balls& balls, int input) {
    push(balls, 1);
    if (input == 7) balls.move(wall, at(1, 0, 0));
  };
  CHECK_FALSE(test.step(scene, 0, simulate));
  const auto desync = test.step(scene, 7, simulate);
  REQUIRE(desync);
  CHECK(desync->frame == 1);
  CHECK(desync->object == wall);
  CHECK(field(*desync) == "object 2:3 (sphere) center.x");
}

TEST_CASE("field name: is a path, truncated if it is too long") {
  FieldName name;
  CHECK(name.view().empty());
  name.add_part(" object ").add_number(1024).add_part("center").add_part("x").add_part("");
  CHECK(name.view() == "object 1024.center.x");
  name.cut(6);
  CHECK(std::string(name.c_str()) == "object");
  CHECK(name.add_part("[").add_number(0).add("]").view() == "object[0]");
  for (int i = 0; i < 100; ++i) name.add_part("long");
  CHECK(name.size() == FieldName::capacity);
  CHECK(std::string(name.c_str()).size() == FieldName::capacity);
}
