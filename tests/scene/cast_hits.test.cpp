// SPDX-License-Identifier: MIT
#include <array>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <vector>

#include "detent/scene/height_field.hpp"
#include "detent/scene/hull.hpp"
#include "detent/scene/mesh.hpp"
#include "detent/scene/mesh/owned.hpp"
#include "detent/scene/scene.hpp"
#include "oracle/draw_shape.hpp"
#include "scene/any_scene.hpp"
#include "support/catch.hpp"

using namespace detent;
using S = q16_16;
using Vec3 = Vec<S, 3>;
using Hit = ObjectHit<S, 3>;
using World = test::AnyScene<S, 3, PlacedMesh<S>, PlacedHull<S, 3>, PlacedField<S>>;

namespace {

Vec3 at(int x, int y, int z) { return {S(x), S(y), S(z)}; }

/// A mesh, a hull and a height field.
struct Stock {
  std::vector<Triangle<S, 3>> triangles;
  std::vector<Vec3> points;
  std::array<S, 12> heights{};
  std::optional<OwnedMesh<S>> owned;
  std::optional<MeshAsset<S>> mesh;
  std::optional<HullAsset<S, 3>> hull;
  std::optional<FieldAsset<S>> field;

  template <class Draw>
  explicit Stock(const Draw& shape) {
    for (int i = 0; i < 40; ++i) triangles.push_back(shape(Triangle<S, 3>()));
    for (int i = 0; i < 9; ++i) points.push_back(shape(Sphere<S, 3>()).center);
    for (auto& height : heights) height = shape(Sphere<S, 3>()).center.y;
    const auto a = points[0], b = points[1];
    const auto cell = std::max(nearest_to<S>(half(half(abs(a.x - b.x)))), S::from_raw(1));
    owned.emplace(std::span<const Triangle<S, 3>>(triangles));
    mesh.emplace(1, owned->view());
    hull = hull_asset(1, ConvexHull<S, 3>{points});
    field.emplace(1, height_field<S>({a.x, a.z}, cell, 4, 3, heights).value_or(HeightField<S>()));
  }
  Stock(const Stock&) = delete;
};

/// The expected hit of one object, given by its shape in world space.
template <class Moving, class Shape>
std::optional<Hit> hit_of(const Cast<Moving>& moving, const ObjectId& id, const Shape& shape) {
  const auto& [body, direction, length] = moving;
  const auto hit = cast(body, direction, length, shape);
  CHECK(hit.has_value() == detail::cast_distance(body, direction, length, shape).has_value());
  if (!hit) return std::nullopt;
  Hit result{hit->distance, id, hit->point, hit->normal, {}};
  if constexpr (is_surface_type<Shape>) {
    result.triangle = cast_nearest(body, direction, length, shape)->index;
  }
  return result;
}

template <class Moving>
void ask(const World& scene, const Cast<Moving>& moving, const InLayers& filter,
         test::HitRate& rate, int& triangles) {
  std::vector<Hit> expected;
  scene.for_each([&](const ObjectInfo& info, const auto& shape) {
    if (!filter(info)) return;
    if (const auto hit = hit_of(moving, info.id, shape)) expected.push_back(*hit);
  });
  std::sort(expected.begin(), expected.end());
  rate.count(!expected.empty());
  for (const auto& hit : expected) triangles += hit.triangle ? 1 : 0;
  test::check_hits(scene, moving, filter, expected);
}

}  // namespace

TEST_CASE("scene: hits of casts equal those of single casts at the objects, for every shape") {
  test::HitRate rate;
  int triangles = 0;
  for (const auto kind : {oracle::Kind::general, oracle::Kind::lattice, oracle::Kind::degenerate}) {
    oracle::Draw<S, 3> draw(5);
    auto& random = draw.random;
    const auto setting = oracle::draw_setting(draw, kind, 100);
    const auto shape = [&]<class T>(T) { return oracle::draw_shape<T>(draw, setting); };
    const auto point = [&] { return shape(Sphere<S, 3>()).center; };
    const Stock stock(shape);
    World scene;
    const auto arm =
        scene.add_frame({.translation = point(), .rotation = shape(Obb<S, 3>()).rotation}).value();
    for (int i = 0; i < 2; ++i) {
      const auto layer = test::add_one_of_each(scene, shape, arm, Vec3());
      Transform<S, 3> place;
      if (i == 0) place.rotation = shape(Obb<S, 3>()).rotation;
      scene.add(PlacedMesh{&*stock.mesh, place},
                {.layers = layer, .frame = i == 0 ? FrameId{} : arm});
      scene.add(PlacedHull<S, 3>{&*stock.hull, place}, {.layers = layer * 2, .frame = arm});
      scene.add(PlacedField<S>{&*stock.field, place.translation}, {.layers = layer * 4});
    }
    scene.add(PlacedMesh<S>());
    scene.add(PlacedHull<S, 3>());
    for (int i = 0; i < 100; ++i) {
      Ray<S, 3> ray{point(), draw.any_direction()};
      if (const auto toward = normalize(nearest_to<S>(point() - ray.origin))) {
        ray.direction = *toward;
      }
      if (random.coin()) ray.max_distance = distance(ray.origin, point());
      const InLayers filter{1u << random.below(9) | 1u << random.below(11)};
      const auto& [origin, direction, length] = ray;
      ask(scene, Cast{shape(Sphere<S, 3>()), direction, length}, filter, rate, triangles);
    }
  }
  INFO(rate << ", " << triangles << " on triangles of meshes");
  CHECK(rate.percent() >= 30);
  CHECK(rate.percent() < 90);
  CHECK(triangles > 40);
}

TEST_CASE("scene: a bounded scene casts without a heap, sorted by distance and id") {
  BoundedScene<Bounded<4>, S, 3, Sphere> scene;
  for (const int x : {9, 5, 5, 20}) scene.add(Sphere{at(x, 0, 0), S(1)});
  const Cast ball{Sphere{at(0, 0, 0), S(1)}, Direction<S, 3>::along(0), S(10)};
  std::array<Hit, 4> room;
  CHECK(scene.all_hits(ball, std::span(room)) == 3);
  CHECK(room[0].distance == S(3));
  CHECK(room[0].id == ObjectId{1, 2});
  CHECK(room[1].distance == S(3));
  CHECK(room[1].id == ObjectId{2, 3});
  CHECK(room[2].distance == S(7));
  CHECK(scene.nearest_hit(ball) == room[0]);
  CHECK(room[0].normal == -Direction<S, 3>::along(0));
  CHECK(scene.any(ball));
  CHECK_FALSE(scene.any(Cast{ball.shape, ball.direction, S::from_raw(3 * 65536 - 1)}));
  CHECK_FALSE(scene.any(Cast{Sphere{at(5, 0, 0), S(-1)}, ball.direction, S(10)}));
  CHECK_FALSE(scene.any(Cast{ball.shape, ball.direction, S(-1)}));
}
