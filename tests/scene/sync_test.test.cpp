// SPDX-License-Identifier: MIT
#include "detent/scene/sync_test.hpp"

#include "support/catch.hpp"

using namespace detent;
using S = q16_16;
using Vec3 = Vec<S, 3>;
using Balls = Scene<S, 3, Sphere>;

namespace {

Balls two_balls() {
  Balls scene;
  scene.add(Sphere{Vec3{}, S(1)});
  scene.add(Sphere{Vec3{S(9), S(0), S(0)}, S(1)});
  return scene;
}

void push(Balls& scene, int input) {
  scene.move({0, 1}, Vec3{S(input), S(0), S(0)});
  if (input == 3) scene.add(Sphere{Vec3{S(1), S(2), S(3)}, S(1)});
}

}  // namespace

TEST_CASE("sync test: a simulation of the scene and the inputs alone never parts") {
  Balls scene = two_balls(), plain = two_balls();
  SyncTest<Balls, int> test(5);
  for (int frame = 0; frame < 30; ++frame) {
    CHECK_FALSE(test.step(scene, frame % 4, push));
    push(plain, frame % 4);
    CHECK(snapshot(scene) == snapshot(plain));
  }
}

TEST_CASE("sync test: names the first frame and object that a hidden counter moves") {
  Balls scene = two_balls();
  SyncTest<Balls, int> test(5);
  int calls = 0;
  const auto with_a_secret = [&](Balls& balls, int input) {
    push(balls, input);
    if (++calls == 20) balls.move({1, 2}, Vec3{S(0), S(1), S(0)});
  };
  std::optional<Desync> desync;
  std::uint64_t frame = 0;
  for (; !desync; ++frame) desync = test.step(scene, 1, with_a_secret);
  // Frame 0 takes 2 calls, frame 1 takes 3, and frame 4 the calls 15 to 20, the last of them anew.
  CHECK(frame == 5);
  CHECK(desync->frame == 4);
  CHECK(desync->object == ObjectId{1, 2});
}

TEST_CASE("sync test: objects that come or go parted are named too") {
  Balls scene = two_balls();
  SyncTest<Balls, int> test(3);
  bool has_run = false;
  const auto desync = test.step(scene, 0, [&](Balls& balls, int) {
    if (has_run) balls.remove({1, 2});
    has_run = true;
  });
  REQUIRE(desync);
  CHECK(desync->frame == 0);
  CHECK(desync->object == ObjectId{1, 2});
}

TEST_CASE("sync test: a fixed object that changes cannot be rolled back") {
  Balls scene = two_balls();
  const auto wall = *scene.add(Sphere{Vec3{}, S(2)}, {.motion = Motion::fixed});
  SyncTest<Balls, int> test(3);
  const auto desync = test.step(scene, 0, [&](Balls& balls, int) {
    balls.move(wall, Vec3{S(1), S(0), S(0)});
  });
  REQUIRE(desync);
  CHECK(desync->object == std::nullopt);
}
