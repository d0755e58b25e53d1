// SPDX-License-Identifier: MIT
#include <array>
#include <cstdint>
#include <vector>

#include "detent/scene/mesh/instance.hpp"
#include "detent/scene/mesh/owned.hpp"
#include "detent/scene/snapshot.hpp"
#include "scene/mover_level.hpp"

namespace detent::test {
namespace {

using S = q16_16;
using Vec3 = Vec<S, 3>;
using Balls = Scene<S, 3, Sphere>;

Vec3 raw(int x, int y, int z) { return {S::from_raw(x), S::from_raw(y), S::from_raw(z)}; }

TEST_CASE("mover: a push does not depend on the order in which objects were added") {
  std::uint32_t seed = 1;
  const auto random = [&](int most) {
    seed = seed * 1664525u + 1013904223u;
    return static_cast<int>(seed >> 8) % (2 * most + 1) - most;
  };
  int pushes = 0;
  for (int round = 0; round < 500; ++round) {
    std::vector<Sphere<S, 3>> balls;
    for (int i = 0; i < 12; ++i) {
      balls.push_back({raw(random(1024), random(1024) - 66304, random(1024)), S(1)});
    }
    Balls forward, backward, restored;
    for (std::uint32_t i = 0; i < 12; ++i) {
      const auto j = 11 - i;
      REQUIRE(forward.add_as({i, i + 1}, balls[i]));
      REQUIRE(backward.add_as({j, j + 1}, balls[j]));
    }
    REQUIRE(restore(restored, snapshot(backward)) == Restored::yes);
    const Mover start{Sphere<S, 3>{raw(0, 32064, 0), quotient_nearest<S>(S(1), S(2))}};
    const auto push = [&](const Balls& world) {
      auto mover = start;
      mover.move(world, {});
      return mover;
    };
    const auto pushed = push(forward);
    pushes += !(pushed == start);
    CHECK(push(backward) == pushed);
    CHECK(push(restored) == pushed);
  }
  CHECK(pushes > 400);
}

TEST_CASE("mover: half-spaces are kept by offset, whatever the order of calls") {
  const auto space = [](int axis, int offset) {
    return detail::HalfSpace<S, 3>{Direction<S, 3>::along(axis % 3), S(offset)};
  };
  std::vector<detail::HalfSpace<S, 3>> all;
  for (int i = 0; i < 6; ++i) all.push_back(space(i, 5 + i));
  for (int i = 0; i < 3; ++i) all.push_back({-Direction<S, 3>::along(i), S(-30)});
  for (int y = 1; y < 6; ++y) {
    all.push_back({*direction_of<S>(Vec3{S(1), S(y), S(0)}), S(y - 20)});
  }
  const auto closest = [](const auto& list) {
    detail::HalfSpaces<S, 3> spaces;
    for (const auto& [normal, offset] : list) spaces.add_sorted(normal, offset);
    return spaces.closest({}, S(0));
  };
  const auto expected = closest(all);
  CHECK(expected == Vec3{S(8), S(9), S(10)});
  for (std::size_t turn = 1; turn < all.size(); ++turn) {
    std::vector<detail::HalfSpace<S, 3>> turned(all.begin() + static_cast<std::ptrdiff_t>(turn),
                                                all.end());
    turned.insert(turned.end(), all.begin(), all.begin() + static_cast<std::ptrdiff_t>(turn));
    CHECK(closest(turned) == expected);
  }
}

TEMPLATE_TEST_CASE("mover: a slow character slides along a wall and up a slope", "", q16_16,
                   float) {
  using T = TestType;
  const auto at = [](int x, int y, int z) {
    const auto number = [](int n) {
      return quotient_nearest<T>(detail::as_operand<T>(n), detail::as_operand<T>(2000));
    };
    return Vec<T, 3>{number(x), number(y), number(z)};
  };
  Level<T> level;
  level.box(level.at(100, -2000, -2000), level.at(200, 2000, 2000));
  auto flier = level.person(0, 0, 0);
  for (int i = 0; i < 100; ++i) flier.move(level.world, level.at(1, 0, 0), level.settings);
  for (int i = 0; i < 1000; ++i) flier.move(level.world, at(3, 0, 20), level.settings);
  CHECK(level.z(flier) > 9.9);
  CHECK(level.x(flier) < 0.6);

  Level<T> hill;
  hill.slope(30);
  auto walker = hill.person(-50, 0, 0);
  hill.walk(walker, 60, 0);
  REQUIRE(walker.ground.is_grounded);
  const double start = hill.x(walker);
  for (int i = 0; i < 1000; ++i) walker.move(hill.world, at(6, -20, 0), hill.settings);
  CHECK(hill.x(walker) - start > 2);
}

TEMPLATE_TEST_CASE("mover: stays on the ground when it walks down a slope", "", q16_16, float) {
  for (const int degrees : {10, 20, 40, 48}) {
    Level<TestType> level;
    level.slope(degrees);
    auto walker = level.person(500, 900, 0);
    level.walk(walker, 300, 0);
    REQUIRE(walker.ground.is_grounded);
    auto velocity = level.at(0, 0, 0);
    const auto run = level.at(-10, 0, 0), gravity = level.at(0, -1, 0);
    for (int i = 0; i < 80; ++i) {
      velocity = nearest_to<TestType>(Vec<TestType, 3>{run.x, velocity.y, run.z} + gravity);
      const auto result = walker.move(level.world, velocity, level.settings);
      velocity = clip_velocity(velocity, result);
      CHECK(walker.ground.is_grounded);
    }
    CHECK(level.x(walker) < 0);
  }
}

TEST_CASE("mover: a tessellated floor pushes a character up, as a box does") {
  std::vector<Triangle<S, 3>> triangles;
  for (int x = -4; x < 4; ++x) {
    for (int z = -4; z < 4; ++z) {
      const auto corner = [&](int i, int k) { return Vec3{S(x + i), S(0), S(z + k)}; };
      triangles.push_back({corner(0, 0), corner(0, 1), corner(1, 1)});
      triangles.push_back({corner(0, 0), corner(1, 1), corner(1, 0)});
    }
  }
  const OwnedMesh<S> mesh{std::span<const Triangle<S, 3>>(triangles)};
  const MeshAsset<S> asset{1, mesh.view()};
  Scene<S, 3, MeshInstance> tiles;
  REQUIRE(tiles.add(PlacedMesh<S>{&asset}));
  Scene<S, 3, Aabb> block;
  REQUIRE(block.add(Aabb<S, 3>{Vec3{S(-4), S(-1), S(-4)}, Vec3{S(4), S(0), S(4)}}));
  const auto push = [](const auto& world, const auto& shape) {
    Mover mover{shape};
    const auto result = mover.move(world, {});
    CHECK(!result.is_stuck);
    return result.pushed;
  };
  const S sunk = quotient_nearest<S>(S(-1), S(10)), wide = quotient_nearest<S>(S(21), S(20)),
          back = nearest_to<S>(-wide);
  const Aabb<S, 3> box{Vec3{back, sunk, back}, Vec3{wide, S(2), wide}};
  CHECK(push(tiles, box) == push(block, box));
  CHECK(push(tiles, box).y > 0);
  const S radius = quotient_nearest<S>(S(1), S(2));
  const Sphere<S, 3> ball{Vec3{radius, nearest_to<S>(radius + sunk), radius}, radius};
  CHECK(push(tiles, ball) == push(block, ball));
}

}  // namespace
}  // namespace detent::test
