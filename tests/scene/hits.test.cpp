// SPDX-License-Identifier: MIT
#include "detent/scene/found.hpp"

#include <array>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "detent/scene/mesh/instance.hpp"
#include "detent/scene/mesh/owned.hpp"
#include "detent/scene/scene.hpp"
#include "oracle/draw_shape.hpp"
#include "scene/any_scene.hpp"
#include "support/catch.hpp"

using namespace detent;
using S = q16_16;
using Vec3 = Vec<S, 3>;
using Hit = ObjectHit<S, 3>;
using World = test::AnyScene<S, 3, PlacedMesh<S>>;

namespace {

Vec3 at(int x, int y, int z) { return {S(x), S(y), S(z)}; }

/// A mesh of triangles whose indices are not in order.
struct Rock {
  std::vector<MeshTriangle<S>> triangles;
  std::array<MeshNode<S>, 20> nodes{};
  MeshAsset<S> asset;

  explicit Rock(oracle::Draw<S, 3>& draw, const oracle::Setting<3>& setting) {
    for (std::uint32_t i = 0; i < 40; ++i) {
      triangles.push_back({oracle::draw_shape<Triangle<S, 3>>(draw, setting), 100 - i});
    }
    asset = MeshAsset<S>(1, *build_mesh<S>(std::span(triangles), std::span(nodes)));
  }
  Rock(const Rock&) = delete;
};

template <class Shape>
Hit hit_of(const Ray<S, 3>& ray, const ObjectId& id, const Shape& shape) {
  const auto hit = raycast_hit(ray, shape);
  REQUIRE(hit);
  Hit result{hit->distance, id, hit->point, hit->normal, {}};
  if constexpr (std::is_same_v<Shape, PlacedMesh<S>>) {
    result.triangle = raycast_nearest(ray, shape)->index;
    // The normal is that of the triangle of this index.
    for (const auto& part : shape.asset->mesh().triangles) {
      if (part.index != result.triangle) continue;
      CHECK(raycast_hit(ray, placed(shape.transform, part.triangle)) == hit);
    }
  }
  return result;
}

}  // namespace

TEST_CASE("scene: hits equal those of single raycasts at the objects, for every shape") {
  test::HitRate rate;
  int triangles = 0;
  for (const auto kind : {oracle::Kind::general, oracle::Kind::lattice, oracle::Kind::degenerate}) {
    oracle::Draw<S, 3> draw(5);
    const auto setting = oracle::draw_setting(draw, kind, 100);
    const auto shape = [&]<class T>(T) { return oracle::draw_shape<T>(draw, setting); };
    const auto point = [&] { return shape(Sphere<S, 3>()).center; };
    const Rock rock(draw, setting);
    World scene;
    const auto arm = scene.add_frame({.translation = point()}).value();
    for (int i = 0; i < 2; ++i) {
      const auto layer = test::add_one_of_each(scene, shape, arm, Vec3());
      Transform<S, 3> place;
      if (i == 0) place.rotation = shape(Obb<S, 3>()).rotation;
      scene.add(PlacedMesh{&rock.asset, place}, {.layers = layer});
    }
    for (int i = 0; i < 100; ++i) {
      Ray<S, 3> ray{point(), draw.any_direction()};
      if (const auto toward = normalize(nearest_to<S>(point() - ray.origin))) {
        ray.direction = *toward;
      }
      if (draw.random.coin()) ray.max_distance = distance(ray.origin, point());
      const InLayers filter{1u << draw.random.below(7) | 1u << draw.random.below(9)};
      std::vector<Hit> expected;
      for (const auto& found : scene.all(ray, filter)) {
        const auto id = found.id;
        CHECK(scene.visit(id, [&](const auto& s) { expected.push_back(hit_of(ray, id, s)); }));
        CHECK(expected.back().distance == found.distance);
        if (expected.back().triangle) ++triangles;
      }
      rate.count(!expected.empty());
      test::check_hits(scene, ray, filter, expected);
    }
  }
  INFO(rate << ", " << triangles << " on triangles of meshes");
  CHECK(rate.is_balanced());
  CHECK(triangles > 50);
}

TEST_CASE("scene: a bounded scene gives hits without a heap, sorted by distance and id") {
  BoundedScene<Bounded<4>, S, 3, Sphere> scene;
  for (const int x : {9, 5, 5, 20}) scene.add(Sphere{at(x, 0, 0), S(1)});
  const Ray<S, 3> ray{at(0, 0, 0), Direction<S, 3>::along(0), S(10)};
  const auto back = -Direction<S, 3>::along(0);
  std::array<Hit, 4> room;
  CHECK(scene.all_hits(ray, std::span(room)) == 3);
  CHECK(room[0] == Hit{S(4), {1, 2}, at(4, 0, 0), back, {}});
  CHECK(room[1] == Hit{S(4), {2, 3}, at(4, 0, 0), back, {}});
  CHECK(room[2] == Hit{S(8), {0, 1}, at(8, 0, 0), back, {}});
  CHECK(scene.nearest_hit(ray) == room[0]);
  const Ray<S, 3> inside{at(5, 0, 0), Direction<S, 3>::along(1)};
  CHECK(scene.nearest_hit(inside) ==
        Hit{S(0), {1, 2}, at(5, 0, 0), -Direction<S, 3>::along(1), {}});
}
