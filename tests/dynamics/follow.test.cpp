// SPDX-License-Identifier: MIT
#include "detent/dynamics/follow.hpp"

#include <array>
#include <type_traits>

#include "detent/scene/mover.hpp"
#include "detent/scene/snapshot.hpp"
#include "detent/scene/world.hpp"
#include "dynamics/stage.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

using S = q16_16;

}  // namespace

TEST_CASE("follow: a body put back under its id may have another motion") {
  World<S, 2, Sphere, Obb> world;
  SceneOf<decltype(world)> scene;
  const BodyId id{3, 5};
  for (const auto motion : {BodyMotion::fixed, BodyMotion::dynamic, BodyMotion::fixed}) {
    for (const bool is_ball : {true, false}) {
      world.remove(id);
      const BodyOptions<S, 2> options{.motion = motion};
      if (is_ball) {
        world.put(id, Sphere<S, 2>{{}, S(1)}, options);
      } else {
        world.put(id, Obb<S, 2>{{}, {S(1), S(1)}, {}}, options);
      }
      follow(scene, world);
      SceneOf<decltype(world)> fresh;
      follow(fresh, world);
      CHECK(detail::WorldDigest(scene).all() == detail::WorldDigest(fresh).all());
      CHECK(detail::WorldDigest(scene).fixed() == detail::WorldDigest(fresh).fixed());
    }
  }
  world.remove(id);
  follow(scene, world);
  CHECK(scene.size() == 0);
}

TEST_CASE("follow: removes objects that are not bodies, and all objects of a cleared world") {
  World<S, 2, Sphere> world;
  world.add(Sphere<S, 2>{{}, S(1)});
  Scene<S, 2, Sphere, Capsule> scene;  // it may name more
  for (int i = 0; i < 5; ++i) scene.add(Capsule<S, 2>{{}, {}, S(1)});
  CHECK(follow(scene, world));
  CHECK(scene.size() == 1);
  CHECK(scene.shape<Sphere<S, 2>>(ObjectId{0, 1}));
  CHECK(follow(scene, World<S, 2, Sphere>()));
  CHECK(scene.size() == 0);
}

TEST_CASE("follow: bounded worlds and scenes need no heap") {
  BoundedWorld<Bounded<8>, S, 2, Sphere, Aabb, BodyCompound> world;
  static_assert(
      std::is_same_v<SceneOf<decltype(world)>, BoundedScene<Bounded<8>, S, 2, Sphere, Obb>>);
  const std::array parts{BodyPart(Sphere<S, 2>{at<S, 2>(0, 0), num<S>(0.5)}),
                         BodyPart(Sphere<S, 2>{at<S, 2>(1, 0), num<S>(0.5)})};
  const auto solid = solid_compound(1, parts).value();
  world.add(Aabb<S, 2>{at<S, 2>(-9, -1), at<S, 2>(9, 0)}, {.motion = BodyMotion::fixed});
  for (int i = 0; i < 4; ++i) world.add(Sphere<S, 2>{at<S, 2>(i, 1 + i), num<S>(0.5)});

  World<S, 2, Sphere, Aabb, BodyCompound> grown;
  world.for_each([&]<class Shape>(const BodyInfo& body, const Shape& shape) {
    const BodyOptions<S, 2> options{.motion = body.motion};
    if constexpr (std::is_same_v<Shape, Sphere<S, 2>>) {
      grown.put(body.id, shape, options);
    } else {
      grown.put(body.id, Aabb<S, 2>{at<S, 2>(-9, -1), at<S, 2>(9, 0)}, options);
    }
  });
  SceneOf<decltype(world)> scene;
  SceneOf<decltype(grown)> wide;
  for (int tick = 0; tick < 90; ++tick) {
    world.step();
    grown.step();
    CHECK(follow(scene, world));
    follow(wide, grown);
    CHECK(snapshot(scene, {}) == snapshot(wide).size());
    REQUIRE(detail::WorldDigest(scene).all() == detail::WorldDigest(wide).all());
  }

  // Eight indices from 8 on would be needed.
  world.add(BodyCompound<S, 2>{&solid, at<S, 2>(0, 9), {}});
  CHECK_FALSE(follow(scene, world));
  CHECK(scene.size() == 5);
  BoundedScene<Bounded<10>, S, 2, Sphere, Obb> roomy;
  CHECK(follow(roomy, world));
  CHECK(roomy.size() == 7);
  CHECK(part_of(world, ObjectId{9, 6}) == PartId{{5, 6}, 1});
}

TEST_CASE("follow: the ids of parts do not depend on bodies that were removed") {
  const std::array parts{BodyPart(Sphere<S, 2>{at<S, 2>(0, 0), num<S>(0.5)}),
                         BodyPart(Sphere<S, 2>{at<S, 2>(1, 0), num<S>(0.5)})};
  const auto solid = solid_compound(1, parts).value();
  World<S, 2, Sphere, BodyCompound> world;
  const auto pair = *world.add(BodyCompound<S, 2>{&solid, {}, {}});
  const BodyId far{100, 7};
  SceneOf<decltype(world)> scene;
  for (const bool is_far : {false, true, false}) {
    is_far ? world.put(far, Sphere<S, 2>{{}, S(1)}) : world.remove(far);
    const std::uint32_t first = is_far ? 128 : 1;
    CHECK(follow(scene, world));
    CHECK(scene.size() == (is_far ? 3 : 2));
    for (std::uint32_t part : {0u, 1u}) {
      const ObjectId id{first + part, pair.generation};
      CHECK(scene.contains(id));
      CHECK(part_of(world, id) == PartId{pair, part});
    }
    CHECK_FALSE(part_of(world, ObjectId{first + 2, pair.generation}));
  }
}

TEST_CASE("follow: answers in constant expressions") {
  constexpr auto found = [] {
    BoundedWorld<Bounded<2>, S, 2, Sphere> world;
    world.add(Sphere<S, 2>{{S(3), S(0)}, S(1)});
    world.add(Sphere<S, 2>{{S(5), S(0)}, S(1)}, {.is_sensor = true});
    SceneOf<decltype(world)> scene;
    follow(scene, world);
    return scene.nearest(Ray{Vec<S, 2>{}, Direction<S, 2>::along(0)});
  }();
  static_assert(found->id == BodyId{0, 1} && found->distance == S(2));
}

TEMPLATE_TEST_CASE("follow: in other scalars", "", q24_8, q8_8, double) {
  using T = TestType;
  using Point = Vec<T, 3>;
  World<T, 3, Sphere, Capsule, Aabb> world;
  const Aabb<T, 3> ground{Point{T(-5), T(-1), T(-5)}, Point{T(5), T(0), T(5)}};
  const auto floor = *world.add(ground, {.motion = BodyMotion::fixed});
  const auto ball = *world.add(Sphere<T, 3>{Point{T(0), T(3), T(0)}, num<T>(0.5)});
  world.add(Capsule<T, 3>{Point{T(3), T(1), T(0)}, Point{T(3), T(2), T(0)}, num<T>(0.5)});
  SceneOf<decltype(world)> scene;
  for (int i = 0; i < 8; ++i) {
    world.set_position(ball, Point{T(0), num<T>(3 - 0.25 * i), T(0)});
    REQUIRE(follow(scene, world));
    const Ray down{Point{T(0), T(9), T(0)}, -Direction<T, 3>::along(1)};
    const auto hit = scene.nearest_hit(down);
    REQUIRE(hit);
    CHECK(hit->id == ball);
    CHECK(hit->distance == raycast(down, Sphere<T, 3>{world.position(ball), num<T>(0.5)}));
    const Ray beside{Point{T(4), T(9), T(4)}, -Direction<T, 3>::along(1)};
    CHECK(scene.nearest(beside)->id == floor);
    CHECK(scene.nearest(beside)->distance == T(9));
  }
}

TEST_CASE("follow: casts, overlaps and characters find bodies") {
  World<S, 3, Sphere, Obb> world;
  const auto floor = *world.add(box_of<S, 3>(0, -1, 20, 1), {.motion = BodyMotion::fixed});
  const auto crate = *world.add(box_of<S, 3>(3, 0.5, 0.5, 0.5), BodyOptions<S, 3>{.layers = 2});
  const auto zone = *world.add(Sphere<S, 3>{at3(1, 1, 0), S(1)},
                               {.motion = BodyMotion::fixed, .is_sensor = true});
  for (int tick = 0; tick < 90; ++tick) world.step();
  CHECK(world.is_asleep(crate));
  SceneOf<decltype(world)> scene;
  follow(scene, world);
  const Sphere<S, 3> ball{at3(0, 0.6, 0), num<S>(0.25)};
  CHECK(scene.nearest_hit(Cast{ball, Direction<S, 3>::along(0), S(9)})->id == crate);
  CHECK_FALSE(scene.nearest_hit(Cast{ball, Direction<S, 3>::along(0), S(9)}, InLayers{1}));
  CHECK(scene.nearest(Sphere<S, 3>{at3(3, 0.5, 0), S(1)})->id == crate);
  CHECK_FALSE(scene.contains(zone));
  REQUIRE(scene.overlaps().size() == 1);  // the crate sinks in a little
  CHECK(scene.overlaps()[0] == Overlap{floor, crate});

  Mover<S, 3, Capsule> walker{{at3(0, 0.75, 0), at3(0, 1.5, 0), num<S>(0.5)}};
  walker.move(scene, at3(9, 0, 0), MoverSettings<S, 3>());
  CHECK(walker.shape.a.x > num<S>(1.5));
  CHECK(walker.shape.a.x < num<S>(2.0));
}

}  // namespace detent::test
