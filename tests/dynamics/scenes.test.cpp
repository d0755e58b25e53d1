// SPDX-License-Identifier: MIT
#include "dynamics/scenes.hpp"

#include <cstdint>

#include "dynamics/step_alike.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

/// What a scene in q16_16 must reach, and how far from it the same scene in double may be.
struct Band {
  int rest;
  double least_sag, most_sag, drift, from_double;
};

void check(const Settled& fixed, const Settled& real, const Band& band, std::uint64_t golden) {
  CAPTURE(fixed.rest, fixed.dx, fixed.dy, fixed.fastest, real.rest, real.dx, real.dy, real.fastest);
  CHECK(fixed.rest >= 0);
  CHECK(fixed.rest <= band.rest);
  CHECK(-fixed.dy >= band.least_sag);
  CHECK(-fixed.dy <= band.most_sag);
  CHECK(std::fabs(fixed.dx) <= band.drift);
  CHECK(fixed.fastest < 5e-4);
  CHECK(std::fabs(fixed.dx - real.dx) <= band.from_double);
  CHECK(std::fabs(fixed.dy - real.dy) <= band.from_double);
  CHECK(fixed.digest == golden);
}

}  // namespace

TEST_CASE("scenes: a stack of 10 stands") {
  check(settle(stack<q16_16, 2>(10, 4), 600), settle(stack<double, 2>(10, 4), 600),
        {25, 0.023, 0.027, 1e-4, 5e-4}, 0xd80f42e1ae1ce712u);
}

TEST_CASE("scenes: a pyramid of base 10 stands") {
  check(settle(pyramid<q16_16>(10, 4), 300), settle(pyramid<double>(10, 4), 300),
        {15, 0.005, 0.008, 4e-3, 1e-3}, 0x21550aac1efe98bcu);
}

TEST_CASE("scenes: a box of mass 100 stands on two of mass 1") {
  check(settle(heavy_top<q16_16, 2>(100, 4), 600), settle(heavy_top<double, 2>(100, 4), 600),
        {40, 0.08, 0.10, 1e-3, 1e-3}, 0x3844ec2cc61fc373u);
}

TEST_CASE("scenes: a house of cards of 3 levels stands") {
  check(settle(house_of_cards<q16_16>(3, 4), 600), settle(house_of_cards<double>(3, 4), 600),
        {15, 0.005, 0.015, 0.02, 1e-3}, 0x2415b787debf0a16u);
}

TEST_CASE("scenes: a stack of 10 in 3D stands") {
  check(settle(stack<q16_16, 3>(10, 8), 300), settle(stack<double, 3>(10, 8), 300),
        {10, 0.004, 0.006, 1e-4, 1e-4}, 0x7646c354dd633a1fu);
}

TEST_CASE("scenes: a box of mass 100 in 3D stands on two of mass 1") {
  check(settle(heavy_top<q16_16, 3>(100, 8), 300), settle(heavy_top<double, 3>(100, 8), 300),
        {20, 0.014, 0.022, 1e-4, 1e-4}, 0x7948486e381b8175u);
}

TEST_CASE("scenes: a heap of 40 boxes comes to rest") {
  auto scene = heap<q16_16>(4);
  scene.step(500);
  CHECK(scene.fastest() < 0.03);
  CHECK(digest(scene.world) == 0x347b24900a865385u);
}

TEST_CASE("scenes: a scene at rest stays at rest") {
  auto scene = stack<q16_16, 2>(10, 4, 0.05);
  scene.step(120);
  REQUIRE(scene.world.is_asleep(scene.top));
  const auto before = digest(scene.world);
  scene.step(10000);
  CHECK(digest(scene.world) == before);
}

TEST_CASE("scenes: the far end of the world gives the same bits, shifted") {
  // Shifts the stack by 20,000 units and more; only positions differ.
  const auto run = [](double x, double y) {
    WorldSettings<q16_16, 2> settings;
    settings.sleep_speed = {};
    World<q16_16, 2, Obb> world(settings);
    BodyOptions<q16_16, 2> fixed;
    fixed.motion = BodyMotion::fixed;
    (void)world.add(box_at<q16_16, 2>(x, y - 1, 50, 1), fixed);
    for (int i = 0; i < 6; ++i) {
      (void)world.add(box_at<q16_16, 2>(x + 0.25 * (i % 3), y + 1 + 1.5 * i, 0.5, 0.5, 0.3 * i));
    }
    for (int t = 0; t < 300; ++t) world.step();
    Digest digest;
    const auto& bodies = detail::WorldAccess::bodies(world);
    const auto origin = bodies[0].state.place;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const auto& state = bodies[i].state;
      digest.add(state.place - origin, state.orientation, state.velocity, state.spin[0]);
    }
    return digest.value();
  };
  const auto here = run(0, 0);
  CHECK(run(20000, -30000) == here);
  CHECK(run(-32000.125, 32000.5) == here);
}

TEST_CASE("scenes: 3D worlds restore bit for bit and do not depend on history") {
  auto world = heap<q16_16>(4).world;
  for (int t = 0; t < 60; ++t) world.step();
  auto fresh = Scene<q16_16, 3>(4).world;
  REQUIRE(restore(fresh, snapshot(world)) == Restored::yes);
  step_alike(world, fresh, 200);
}

}  // namespace detent::test
