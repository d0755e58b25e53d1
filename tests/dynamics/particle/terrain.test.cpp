// SPDX-License-Identifier: MIT
#include "detent/dynamics/particle/terrain.hpp"

#include <array>
#include <span>
#include <vector>

#include "detent/dynamics/particle/system.hpp"
#include "detent/dynamics/particle/world.hpp"
#include "detent/number/literals.hpp"
#include "detent/query/overlaps/aabb_triangle.hpp"
#include "detent/scene/mesh/owned.hpp"
#include "dynamics/stage.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace detent::test {

using namespace literals;

namespace {

using S = q16_16;
using Point = Vec<S, 3>;

/// Level ground of 450 triangles, which are in another order in the tree.
std::vector<Triangle<S, 3>> ground() {
  std::vector<Triangle<S, 3>> triangles;
  for (int i = 0; i < 15; ++i) {
    for (int k = 0; k < 15; ++k) {
      const auto at = [&](int x, int z) { return at3(i + x - 7.5, 0, k + z - 7.5); };
      triangles.push_back({at(0, 0), at(0, 1), at(1, 0)});
      triangles.push_back({at(1, 0), at(0, 1), at(1, 1)});
    }
  }
  return triangles;
}

/// A mesh that lies level, a height field, and a mesh that rises and turns.
struct Land {
  std::vector<Triangle<S, 3>> triangles = ground();
  OwnedMesh<S> owned{std::span<const Triangle<S, 3>>(triangles)};
  MeshAsset<S> asset{1, owned.view()};
  std::array<S, 9> heights{0_q16_16, 0.5_q16_16, 0_q16_16, 1_q16_16, 0_q16_16,
                           1_q16_16, 0_q16_16,   0_q16_16, 0_q16_16};
  FieldAsset<S> hills{2, height_field<S>({-3_q16_16, -3_q16_16}, 3_q16_16, 3, 3, heights).value()};
  World<S, 3, BodyMesh, BodyHeightField> world;
  BodyId lift;

  Land() {
    BodyOptions<S, 3> kinematic, sensor;
    kinematic.motion = BodyMotion::kinematic;
    kinematic.velocity = at3(0.5, 0.25, 0);
    kinematic.angular_velocity = {0_q16_16, 1_q16_16, 0.5_q16_16};
    sensor.is_sensor = true;
    const auto turn = to_rotation(Quat<S>::from_raw({644245094, 0, 0, 858993459}).value());
    REQUIRE(world.add(BodyMesh<S, 3>{&asset, at3(9, -2, 0), {}}));
    REQUIRE(world.add(BodyHeightField<S, 3>{&hills, at3(9, 1, 0)}));
    lift = world.add(BodyMesh<S, 3>{&asset, at3(-12, -1, 0.1), turn}, kinematic).value();
    REQUIRE(world.add(BodyMesh<S, 3>{&asset, at3(9, 4, 0), {}}, sensor));
    REQUIRE(world.add(BodyMesh<S, 3>{nullptr, at3(9, 4, 0), {}}));
  }
  Land(const Land&) = delete;
  Land& operator=(const Land&) = delete;
};

}  // namespace

TEST_CASE("particle terrain: particles pass no body that is a mesh or height field") {
  Land land;
  ParticleSystem<S, 3> system;
  Random random(12);
  for (int i = 0; i < 60; ++i) {
    const auto number = [&](int least, int most) {
      return least + static_cast<double>(random.below(10001)) / 10000 * (most - least);
    };
    ParticleOptions<S, 3> options;
    options.velocity = at3(number(-3, 3), number(-80, 0), number(-3, 3));
    options.radius = num<S>(number(0, 1) / 10);
    REQUIRE(system.add(at3(number(4, 14), number(3, 4), number(-5, 5)), options));
  }
  std::size_t touched = 0, on_hills = 0, on_ground = 0;
  for (int t = 0; t < 60; ++t) {
    land.world.step();
    const auto around = obstacles_of(land.world);
    system.step(around);
    for (ParticleIndex i = 0; i < system.size(); ++i) {
      const auto ball = system.ball(i);
      around(bounding_box(ball), [&](const auto& shape) { touched += overlaps(shape, ball); });
      // Nothing falls through the ground while it is above it.
      const auto& p = ball.center;
      const bool is_above = 2_q16_16 < p.x && p.x < 16_q16_16 && abs(p.z) < 7_q16_16;
      if (is_above) REQUIRE(p.y >= -2_q16_16);
    }
  }
  for (ParticleIndex i = 0; i < system.size(); ++i) {
    const auto y = system.ball(i).center.y;
    on_hills += 0.9_q16_16 < y && y < 2.5_q16_16;
    on_ground += -2.1_q16_16 < y && y < -1.7_q16_16;
  }
  CHECK(touched == 0);
  CHECK(on_hills >= 5);
  CHECK(on_ground >= 5);
}

TEST_CASE("particle terrain: a box meets each triangle that it touches, once and in order") {
  Land land;
  for (int t = 0; t < 45; ++t) land.world.step();
  const auto pose = land.world.pose(land.lift);
  const auto center = land.world.position(land.lift);
  for (const auto& reach : {0.3_q16_16, 2_q16_16, 12_q16_16}) {
    const auto corner = [&](const S& far) {
      return make_vec<3>([&](int i) { return nearest_to<S>(center[i] + far); });
    };
    std::vector<Triangle<S, 3>> met;
    obstacles_of(land.world)(Aabb<S, 3>{corner(nearest_to<S>(-reach)), corner(reach)},
                             [&](const Triangle<S, 3>& triangle) { met.push_back(triangle); });
    // The pose is rounded before it places a corner, so that one may be off by some steps.
    const auto far = nearest_to<S>(reach - 0.01_q16_16);
    const Aabb<S, 3> inner{corner(nearest_to<S>(-far)), corner(far)};
    const auto is_at = [](const Point& a, const Point& b) {
      return squared_length(a - b) < 0.0001_q16_16;
    };
    std::size_t next = 0, count = 0;
    for (const auto& triangle : land.triangles) {
      const auto there = placed(pose, triangle);
      if (!overlaps(inner, there)) continue;
      ++count;
      while (next < met.size() && !(is_at(met[next].a, there.a) && is_at(met[next].c, there.c))) {
        ++next;
      }
      REQUIRE(next++ < met.size());
    }
    CHECK(count >= 2);
    CHECK(met.size() < 3 * count + 6);
    if (reach == 12_q16_16) CHECK(count == 450);
  }
}

}  // namespace detent::test
