// SPDX-License-Identifier: MIT
#include "detent/dynamics/in_world.hpp"

#include <type_traits>
#include <vector>

#include "detent/scene/hull.hpp"
#include "dynamics/zoo.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

using S = q16_16;

/// Whether two points are the same but for `ulps` along each axis.
template <int N>
bool is_near(const Vec<S, N>& a, const Vec<S, N>& b, int ulps) {
  for (int i = 0; i < N; ++i) {
    if (abs(a[i] - b[i]) > S::from_raw(ulps)) return false;
  }
  return true;
}

/// The shape of a body of one type.
template <class Shape, class World>
Shape shape_of(const World& world, const BodyId& id) {
  Shape result{};
  int count = 0;
  CHECK(world.visit(id, [&]<class Other>(const BodyInfo&, const Other& shape) {
    ++count;
    if constexpr (std::is_same_v<Shape, Other>) {
      result = shape;
    } else {
      FAIL("another type of shape");
    }
  }));
  CHECK(count == 1);
  return result;
}

}  // namespace

TEMPLATE_TEST_CASE("world: shapes of bodies are at their poses", "", Dim<2>, Dim<3>) {
  constexpr int N = TestType::value;
  Zoo<S, N> zoo(GENERATE(1, 2, 3));
  auto& world = zoo.world;
  for (int i = 0; i < 40; ++i) world.step();

  const auto ball = *world.add(Sphere<S, N>{zoo.somewhere(), num<S>(0.25)});
  const Capsule<S, N> rod{{}, at<S, N>(0.5, 1), num<S>(0.25)};
  const Capsule<S, N> local{at<S, N>(-0.25, -0.5), at<S, N>(0.25, 0.5), num<S>(0.25)};
  const auto capsule = *world.add(rod);
  const auto box = *world.add(box_of<S, N>(1, 2, 0.5, 0.25));
  for (int i = 0; i < 30; ++i) world.step();

  CHECK(shape_of<Sphere<S, N>>(world, ball) == Sphere<S, N>{world.position(ball), num<S>(0.25)});
  CHECK(shape_of<Capsule<S, N>>(world, capsule) == placed(world.pose(capsule), local));
  const auto half = box_of<S, N>(0, 0, 0.5, 0.25).half_extents;
  CHECK(shape_of<Obb<S, N>>(world, box) ==
        Obb<S, N>{world.position(box), half, world.rotation(box)});
}

TEMPLATE_TEST_CASE("world: an aligned box is an Obb that contains it", "", Dim<2>, Dim<3>) {
  constexpr int N = TestType::value;
  World<S, N, Aabb> world;
  Aabb<S, N> even{at<S, N>(1, 2), at<S, N>(3, 3)}, odd = even, empty = even;
  if constexpr (N == 3) even.max.z = odd.max.z = empty.max.z = num<S>(4);
  odd.max.x = S::from_raw(odd.max.x.raw() + 1);
  empty.min.x = S::from_raw(empty.max.x.raw() + 1);
  const auto a = shape_of<Obb<S, N>>(world, *world.add(even));
  for (int i = 0; i < N; ++i) {
    CHECK(a.center[i] - a.half_extents[i] == even.min[i]);
    CHECK(a.center[i] + a.half_extents[i] == even.max[i]);
  }
  const auto b = shape_of<Obb<S, N>>(world, *world.add(odd));
  CHECK(b.center.x + b.half_extents.x == odd.max.x);
  CHECK(b.center.x - b.half_extents.x == S::from_raw(odd.min.x.raw() - 1));
  CHECK(is_empty(shape_of<Obb<S, N>>(world, *world.add(empty))));
}

TEMPLATE_TEST_CASE("world: hulls and parts of compounds are where they were given", "", Dim<2>,
                   Dim<3>) {
  constexpr int N = TestType::value;
  std::array<Vec<S, N>, 4> corners{};
  for (int i = 0; i < N; ++i) corners[static_cast<std::size_t>(i)][i] = num<S>(3);
  corners[3] = at<S, N>(2, 2);
  const auto solid = solid_hull(5, ConvexHull<S, N>{corners}).value();
  const std::vector<BodyPart<S, N>> parts{
      BodyPart(box_of<S, N>(1, 0, 0.5, 0.25)),
      BodyPart(Sphere<S, N>{at<S, N>(0, 2), num<S>(0.5)},
               PartOptions<S>{.density = {}, .is_sensor = true}),
      BodyPart(BodyHull<S, N>{&solid, at<S, N>(-4, 0), {}})};
  const auto compound = solid_compound(6, parts).value();
  World<S, N, Sphere, Obb, BodyHull, BodyCompound> world;
  BodyOptions<S, N> options{.user = 77};
  options.angular_velocity[0] = num<S>(2);
  const auto hull = *world.add(BodyHull<S, N>{&solid, at<S, N>(9, 9), {}}, options);
  const auto hammer = *world.add(BodyCompound<S, N>{&compound, at<S, N>(-9, 9), {}}, options);
  for (int i = 0; i < 30; ++i) world.step();

  const auto there = shape_of<PlacedHull<S, N>>(world, hull);
  CHECK(there.asset == &solid.asset());
  CHECK(there.asset->id() == 5);
  CHECK(there.transform == world.frame(hull));
  const detail::HullPoints<S, N> moved(there);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    CHECK(moved.hull().points[i] == transform_point(world.frame(hull), corners[i]));
  }

  std::vector<BodyInfo> seen;
  CHECK(world.visit(hammer, [&]<class Shape>(const BodyInfo& info, const Shape& shape) {
    seen.push_back(info);
    const auto frame = world.frame(hammer);
    if constexpr (std::is_same_v<Shape, Sphere<S, N>>) {
      CHECK(info.part == 1);
      CHECK(is_near(shape.center, transform_point(frame, at<S, N>(0, 2)), 2));
    } else if constexpr (std::is_same_v<Shape, Obb<S, N>>) {
      CHECK(info.part == 0);
      CHECK(is_near(shape.center, transform_point(frame, at<S, N>(1, 0)), 2));
      CHECK(shape.half_extents == box_of<S, N>(0, 0, 0.5, 0.25).half_extents);
    } else {
      CHECK(info.part == 2);
      const auto origin = transform_point(frame, at<S, N>(-4, 0));
      CHECK(is_near(shape.transform.translation, origin, 2));
    }
  }));
  REQUIRE(seen.size() == 3);
  for (std::uint32_t i = 0; i < 3; ++i) {
    CHECK(seen[i].part == i);
    CHECK(seen[i].id == hammer);
    CHECK(seen[i].user == 77);
    CHECK(seen[i].is_sensor == (i == 1));
  }
}

TEST_CASE("world: meshes and height fields are in the form of scenes") {
  Zoo<S, 3> zoo(1);
  const BodyId mesh{0, 1}, field{1, 2};
  CHECK(shape_of<PlacedMesh<S>>(zoo.world, mesh).transform == zoo.world.pose(mesh));
  CHECK(shape_of<PlacedField<S>>(zoo.world, field).translation == zoo.world.position(field));
}

TEMPLATE_TEST_CASE("world: lists its bodies in order of index", "", Dim<2>, Dim<3>) {
  constexpr int N = TestType::value;
  Zoo<S, N> zoo(4);
  auto& world = zoo.world;
  for (int round = 0; round < 20; ++round) zoo.live();
  std::vector<BodyInfo> bodies, of_shapes;
  world.for_each([&](const BodyInfo& body) { bodies.push_back(body); });
  world.for_each([&](const BodyInfo& body, const auto&) {
    if (of_shapes.empty() || of_shapes.back().id != body.id) of_shapes.push_back(body);
  });
  CHECK(bodies.size() == world.size());
  REQUIRE(of_shapes.size() == bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    CHECK((i == 0 || bodies[i - 1].id.index < bodies[i].id.index));
    CHECK(of_shapes[i].id == bodies[i].id);
    CHECK(world.info(bodies[i].id) == bodies[i]);
    CHECK(bodies[i].is_asleep == world.is_asleep(bodies[i].id));
    CHECK(world.visit(bodies[i].id, [&](const BodyInfo& info) { CHECK(info == bodies[i]); }));
  }
  CHECK_FALSE(world.info(no_object));
  CHECK_FALSE(world.visit(no_object, [](const BodyInfo&) { FAIL("no body"); }));
}

TEST_CASE("world: returns the properties of a body") {
  World<S, 2, Sphere> world;
  const BodyOptions<S, 2> options{.motion = BodyMotion::kinematic,
                                  .is_sensor = true,
                                  .layers = 6,
                                  .collides_with = 5,
                                  .user = 9};
  const auto id = *world.add(Sphere<S, 2>{{}, S(1)}, options);
  const auto info = world.info(id).value();
  CHECK(info == BodyInfo{id, 0, BodyMotion::kinematic, 6, 5, 9, true, false});
  CHECK(InLayers{2}(info));
  CHECK_FALSE(InLayers{1}(info));
  CHECK(ObjectInfo(info).motion == Motion::moving);
}

namespace {
constexpr int visited_at_compile_time() {
  BoundedWorld<Bounded<2>, S, 2, Sphere, Obb> world;
  world.add(Sphere<S, 2>{{}, S(1)});
  world.add(Obb<S, 2>{{}, {S(1), S(1)}, {}});
  int count = 0;
  world.for_each(
      [&](const BodyInfo& body, const auto&) { count += 1 + static_cast<int>(body.id.index); });
  return count;
}
static_assert(visited_at_compile_time() == 3);
}  // namespace

}  // namespace detent::test
