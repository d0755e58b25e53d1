// SPDX-License-Identifier: MIT
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "detent/dynamics/follow.hpp"
#include "detent/scene/snapshot.hpp"
#include "detent/scene/world.hpp"
#include "dynamics/zoo.hpp"
#include "support/catch.hpp"

// Scenes that follow worlds of every kind of body.

namespace detent::test {
namespace {

using S = q16_16;

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
  const auto seed = GENERATE(1, 2, 3, 5);
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

}  // namespace detent::test
