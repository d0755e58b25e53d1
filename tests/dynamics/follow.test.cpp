// SPDX-License-Identifier: MIT
#include "detent/dynamics/follow.hpp"

#include <algorithm>
#include <optional>
#include <type_traits>
#include <vector>

#include "detent/scene/mover.hpp"
#include "detent/scene/snapshot.hpp"
#include "dynamics/zoo.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

using S = q16_16;

template <int N>
struct Dim {
  static constexpr int value = N;
};

struct All {
  bool operator()(const BodyInfo&) const noexcept { return true; }
};

/// The first hit among the shapes that a world lists, one by one; of equal distances the least id
/// of an object counts, so parts of compounds come last.
template <class World, class Filter>
std::optional<std::pair<S, PartId>> first_hit(const World& world,
                                              const Ray<S, World::dimension>& ray,
                                              const Filter& filter) {
  std::optional<std::pair<S, PartId>> best[2];
  world.for_each([&]<class Shape>(const BodyInfo& body, const Shape& shape) {
    if (!filter(body)) return;
    const auto distance = raycast(ray, shape);
    const bool is_compound =
        detail::part_count(detail::WorldAccess::bodies(world)[body.id.index]) != 0;
    auto& first = best[is_compound ? 1 : 0];
    if (distance && (!first || *distance < first->first)) {
      first = {*distance, PartId{body.id, body.part}};
    }
  });
  if (!best[0] || (best[1] && best[1]->first < best[0]->first)) return best[1];
  return best[0];
}

template <class Scene, class World, class Zoo, class Filter>
void check_hits(const Scene& scene, const World& world, Zoo& zoo, const Filter& filter, int rays,
                int& hits) {
  for (int i = 0; i < rays; ++i) {
    const Ray<S, World::dimension> ray{zoo.somewhere(), zoo.direction(), num<S>(20)};
    const auto hit = scene.nearest_hit(ray);
    const auto expected = first_hit(world, ray, filter);
    REQUIRE(hit.has_value() == expected.has_value());
    if (!hit) continue;
    ++hits;
    CHECK(hit->distance == expected->first);
    CHECK(part_of(world, hit->id) == expected->second);
    CHECK(scene.info(hit->id)->user == world.info(expected->second.body)->user);
  }
}

}  // namespace

TEMPLATE_TEST_CASE("follow: the scene is that of a world without a history", "", Dim<2>, Dim<3>) {
  constexpr int N = TestType::value;
  const auto seed = GENERATE(1, 2, 3, 4);
  INFO("seed " << seed);
  Zoo<S, N> zoo(static_cast<std::uint64_t>(seed));
  using Bodies = typename Zoo<S, N>::Bodies;
  SceneOf<Bodies> solids, all;
  std::vector<Bodies> saved;
  int hits = 0, rays = 0, asleep = 0;
  for (int round = 0; round < 25; ++round) {
    zoo.live();
    if (zoo.random.one_in(3)) saved.push_back(zoo.world);
    if (!saved.empty() && zoo.random.one_in(5)) zoo.world = saved[zoo.random.below(saved.size())];
    if (zoo.random.one_in(4)) continue;  // more changes before the next time
    const auto& world = zoo.world;
    CHECK(follow(solids, world));
    CHECK(follow(all, world, All()));

    SceneOf<Bodies> fresh, fresh_all;
    follow(fresh, world);
    follow(fresh_all, world, All());
    REQUIRE(detail::WorldDigest(solids).all() == detail::WorldDigest(fresh).all());
    REQUIRE(detail::WorldDigest(solids).fixed() == detail::WorldDigest(fresh).fixed());
    REQUIRE(detail::WorldDigest(all).all() == detail::WorldDigest(fresh_all).all());
    REQUIRE(solids.overlaps() == fresh.overlaps());
    CHECK(snapshot(solids) == snapshot(fresh));

    check_hits(solids, world, zoo, Solids(), 10, hits);
    check_hits(all, world, zoo, All(), 10, hits);
    rays += 20;
    world.for_each([&](const BodyInfo& body) { asleep += body.is_asleep; });
  }
  CHECK(10 * hits > 3 * rays);
  CHECK(10 * hits < 9 * rays);
  CHECK(asleep > 0);
}

TEMPLATE_TEST_CASE("follow: objects have the ids and properties of their bodies", "", Dim<2>,
                   Dim<3>) {
  constexpr int N = TestType::value;
  Zoo<S, N> zoo(9);
  for (int round = 0; round < 10; ++round) zoo.live();
  const auto& world = zoo.world;
  SceneOf<typename Zoo<S, N>::Bodies> scene;
  follow(scene, world, All());
  std::size_t objects = 0;
  world.for_each([&]<class Shape>(const BodyInfo& body, const Shape& shape) {
    ++objects;
    if (detail::part_count(detail::WorldAccess::bodies(world)[body.id.index]) != 0) {
      CHECK_FALSE(scene.contains(body.id));
      return;
    }
    const auto info = scene.info(body.id).value();
    CHECK(info.layers == body.layers);
    CHECK(info.user == body.user);
    CHECK((info.motion == Motion::fixed) == (body.motion == BodyMotion::fixed));
    CHECK(scene.template shape<Shape>(body.id) == shape);
  });
  CHECK(scene.size() == objects);
  scene.for_each([&]<class Shape>(const ObjectInfo& info, const Shape& shape) {
    const auto part = part_of(world, info.id).value();
    int found = 0;
    world.visit(part.body, [&]<class Other>(const BodyInfo& body, const Other& other) {
      if (body.part != part.part) return;
      ++found;
      if constexpr (std::is_same_v<Shape, Other>) {
        CHECK(shape == other);
      } else {
        FAIL("another type of shape");
      }
    });
    CHECK(found == 1);
  });
  CHECK_FALSE(part_of(world, no_object));
  CHECK_FALSE(part_of(world, ObjectId{1u << 19, 1}));
}

TEST_CASE("follow: a body put back under its id may move in another way") {
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

TEST_CASE("follow: removes what is no body, and leaves nothing of a cleared world") {
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

TEST_CASE("follow: casts, overlaps and characters find bodies") {
  World<S, 3, Sphere, Obb> world;
  const auto floor = *world.add(box_of<S, 3>(0, -1, 20, 1), fixed<S>());
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
