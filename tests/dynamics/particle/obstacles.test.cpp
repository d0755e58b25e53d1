// SPDX-License-Identifier: MIT
#include "detent/dynamics/particle/obstacles.hpp"

#include <array>
#include <cstddef>
#include <set>
#include <span>
#include <type_traits>
#include <typeindex>

#include "detent/dynamics/particle/cloth.hpp"
#include "detent/dynamics/particle/world.hpp"
#include "detent/number/literals.hpp"
#include "detent/query/overlaps.hpp"
#include "detent/scene/height_field.hpp"
#include "detent/scene/mesh.hpp"
#include "detent/scene/mesh/owned.hpp"
#include "dynamics/stage.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace detent::test {

using namespace literals;

namespace {

using S = q16_16;
using Point = Vec<S, 3>;

std::array<Point, 4> tetrahedron(const Point& by) {
  std::array<Point, 4> points{at3(0, 0.7, 0), at3(0.6, -0.5, 0), at3(-0.4, -0.5, 0.5),
                              at3(-0.4, -0.5, -0.5)};
  for (auto& point : points) point = nearest_to<S>(point + by);
  return points;
}

/// Particles that fly in all directions.
ParticleSystem<S, 3> swarm(int count) {
  ParticleSettings<S, 3> settings;
  settings.restitution = 0.5_q16_16;
  settings.friction = 0.1_q16_16;
  ParticleSystem<S, 3> system(settings);
  Random random(11);
  const auto number = [&](double least, double most) {
    return least + (most - least) * static_cast<double>(random.below(10001)) / 10000;
  };
  for (int i = 0; i < count; ++i) {
    ParticleOptions<S, 3> options;
    options.velocity = at3(number(-6, 6), number(-90, 0), number(-6, 6));
    options.radius = num<S>(number(0, 0.1));
    REQUIRE(system.add(at3(number(-6, 6), number(4.5, 6), number(-1.5, 1.5)), options));
  }
  return system;
}

/// Steps a swarm and counts the types of shapes hit; none is ever touched.
template <class Around>
std::size_t rain(const Around& around, int ticks) {
  auto system = swarm(150);
  std::set<std::type_index> met;
  for (int t = 0; t < ticks; ++t) {
    system.step(around);
    for (ParticleIndex i = 0; i < system.size(); ++i) {
      const auto ball = system.ball(i);
      const Sphere<S, 3> close{ball.center, nearest_to<S>(ball.radius + 0.1_q16_16)};
      around(bounding_box(close), [&](const auto& shape) {
        REQUIRE_FALSE(overlaps(shape, ball));
        if (overlaps(shape, close)) met.insert(typeid(shape));
      });
    }
  }
  return met.size();
}

}  // namespace

TEST_CASE("obstacles: particles pass no shape of any kind") {
  const Plane<S, 3> floor{Direction<S, 3>::from_raw({0, 1 << 30, 0}).value(), -1_q16_16};
  const std::array balls{Sphere<S, 3>{at3(-5, 1, 0), 1_q16_16},
                         Sphere<S, 3>{at3(5, 1, 1), 0.75_q16_16}};
  const Capsule<S, 3> capsule{at3(-3, 0, -1), at3(-3, 2, 1), 0.5_q16_16};
  const Aabb<S, 3> aligned{at3(-1.5, 0, -1), at3(-0.5, 1, 1)};
  const Obb<S, 3> turned{
      at3(1.5, 1, 0), at3(0.7, 0.2, 0.9),
      to_rotation(Quat<S>::from_raw({429496730, 0, 0, 984119136}).value_or(Quat<S>()))};
  const auto corners = tetrahedron(at3(3, 1, 0));
  const ConvexHull<S, 3> hull{corners};
  const std::array parts{Sphere<S, 3>{at3(0, 3, 0), 0.5_q16_16}};
  const Compound compound{parts};
  const std::array<Triangle<S, 3>, 2> tent{
      Triangle<S, 3>{at3(-6, 3, -2), at3(-6, 3, 2), at3(-4, 4, -2)},
      Triangle<S, 3>{at3(-4, 4, 2), at3(-6, 3, 2), at3(-4, 4, -2)}};
  const OwnedMesh<S> mesh{std::span<const Triangle<S, 3>>(tent)};
  const auto view = mesh.view();
  const std::array<S, 9> heights{-1_q16_16, 0_q16_16,  -1_q16_16, 0_q16_16, 1_q16_16,
                                 0_q16_16,  -1_q16_16, 0_q16_16,  -1_q16_16};
  const auto hills = height_field<S>({6_q16_16, -3_q16_16}, 3_q16_16, 3, 3, heights);
  REQUIRE(hills);
  const auto all =
      obstacles<S, 3>(floor, balls, capsule, aligned, turned, hull, compound, view, *hills);
  CHECK(rain(all, 60) == 7);
}

TEST_CASE("obstacles: bodies of a world, at their current poses, except sensors") {
  World<S, 3, Sphere, Obb, BodyHull> world;
  BodyOptions<S, 3> fixed, sensor;
  fixed.motion = BodyMotion::fixed;
  sensor.is_sensor = true;
  sensor.motion = BodyMotion::fixed;
  REQUIRE(world.add(Obb<S, 3>{at3(0, -1, 0), at3(20, 1, 20), {}}, fixed));
  const auto corners = tetrahedron({});
  const auto solid = solid_hull(1, ConvexHull<S, 3>{corners});
  REQUIRE(solid);
  const auto hull = world.add(BodyHull<S, 3>{&*solid, at3(0, 2, 0), {}});
  const auto ball = world.add(Sphere<S, 3>{at3(4, 3, 0), 1_q16_16});
  const auto ghost = world.add(Sphere<S, 3>{at3(-4, 3, 0), 1_q16_16}, sensor);
  REQUIRE((hull && ball && ghost));
  auto system = swarm(30);
  for (int t = 0; t < 60; ++t) {
    world.step();
    const auto around = obstacles_of(world);
    system.step(around);
    for (ParticleIndex i = 0; i < system.size(); ++i) {
      around(bounding_box(system.ball(i)),
             [&](const auto& shape) { REQUIRE_FALSE(overlaps(shape, system.ball(i))); });
    }
  }
  int count = 0;
  const Aabb<S, 3> everything{at3(-90, -90, -90), at3(90, 90, 90)};
  obstacles_of(world)(everything, [&](const auto&) { ++count; });
  CHECK(count == 3);
  obstacles_of(world, 2)(everything, [&](const auto&) { ++count; });
  CHECK(count == 3);
  // The corners are relative to the body's position, its center of mass.
  Aabb<S, 3> box = detail::no_box<Aabb<S, 3>>;
  obstacles_of(world)(everything, [&]<class Shape>(const Shape& shape) {
    if constexpr (std::is_same_v<Shape, ConvexHull<S, 3>>) box = bounding_box(shape);
  });
  CHECK(overlaps(box, Sphere<S, 3>{world.position(*hull), 0.01_q16_16}));
}

TEST_CASE("obstacles: objects of a scene are obstacles") {
  Scene<S, 3, Sphere, Capsule> scene;
  REQUIRE(scene.add(Sphere<S, 3>{at3(0, -20, 0), 20_q16_16}));
  REQUIRE(scene.add(Capsule<S, 3>{at3(-2, 2, 0), at3(2, 2, 0), 0.5_q16_16}));
  const auto around = obstacles_of(scene);
  CHECK(rain(obstacles<S, 3>(around), 60) == 2);
}

}  // namespace detent::test
