// SPDX-License-Identifier: MIT
#include <deque>
#include <variant>
#include <vector>

#include "detent/scene/height_field.hpp"
#include "detent/scene/hull.hpp"
#include "detent/scene/mesh.hpp"
#include "detent/scene/mesh/owned.hpp"
#include "scene/placed_histories.hpp"

namespace detent::test {
namespace {

using S = q16_16;
using Vec3 = Vec<S, 3>;

/// The transformed points of a hull.
struct PlainHull {
  std::vector<Vec3> points;
};
ConvexHull<S, 3> asked(const PlainHull& hull) { return {hull.points}; }

/// The assets and the data that they refer to.
struct Stock {
  using World = AnyScene<S, 3, PlacedMesh<S>, PlacedHull<S, 3>, PlacedField<S>>;
  using Local = AnyShape<S, 3, PlacedMesh<S>, PlacedHull<S, 3>, PlacedField<S>>;
  using Shown = AnyShape<S, 3, TriangleLoop<S>, PlainHull>;

  std::deque<std::vector<Triangle<S, 3>>> triangles;
  std::deque<OwnedMesh<S>> owned;
  std::deque<std::vector<Vec3>> points;
  std::deque<std::vector<S>> heights;
  std::vector<MeshAsset<S>> meshes;
  std::vector<HullAsset<S, 3>> hulls;
  std::vector<FieldAsset<S>> fields;

  explicit Stock(Historian<S, 3>& history) {
    auto& random = history.random();
    for (std::uint32_t id = 0; id < 3; ++id) {
      triangles.emplace_back(random.below(6));
      for (auto& triangle : triangles.back()) triangle = history.draw<Triangle<S, 3>>();
      owned.emplace_back(std::span<const Triangle<S, 3>>(triangles.back()));
      meshes.emplace_back(id, owned.back().view());
      points.emplace_back(id == 0 ? random.below(3) : random.below(14));
      for (auto& point : points.back()) point = history.point();
      hulls.push_back(*hull_asset(id, ConvexHull<S, 3>{points.back()}));
      fields.emplace_back(id, draw_field(history));
    }
  }

  Local draw(Historian<S, 3>& history) const {
    auto& random = history.random();
    const auto at = random.below(3);
    const auto transform = draw_transform(history);
    switch (random.below(9)) {
      case 0:
      case 1:
      case 2:
        return PlacedHull<S, 3>{random.one_in(9) ? nullptr : &hulls[at], transform};
      case 3:
      case 4:
        return PlacedField<S>{random.one_in(9) ? nullptr : &fields[at], transform.translation};
      case 5:
        return PlacedMesh<S>{&meshes[at], transform};
      default:
        return support::SceneShapes<S, 3>::at(
            random.below(support::SceneShapes<S, 3>::size),
            [&]<class Shape>(const Shape&) -> Local { return history.draw<Shape>(); });
    }
  }
  template <class Shape>
  Shown shown(const Shape& shape) const {
    if constexpr (std::is_same_v<Shape, PlacedMesh<S>>) {
      return loop_of(shape, triangles);
    } else if constexpr (std::is_same_v<Shape, PlacedHull<S, 3>>) {
      PlainHull hull;
      if (shape.asset == nullptr) return hull;
      for (const auto& point : points[shape.asset->id()]) {
        hull.points.push_back(transform_point(shape.transform, point));
      }
      return hull;
    } else if constexpr (std::is_same_v<Shape, PlacedField<S>>) {
      TriangleLoop<S> loop;
      if (shape.asset == nullptr) return loop;
      const auto& field = shape.asset->field();
      for (std::uint32_t row = 0; row + 1 < field.rows; ++row) {
        for (std::uint32_t column = 0; column + 1 < field.columns; ++column) {
          for (const auto& part : cell_triangles(field, column, row)) {
            loop.triangles.push_back(translated(part.triangle, shape.translation));
          }
        }
      }
      return loop;
    } else {
      return shape;
    }
  }
  const auto& list_of(const PlacedMesh<S>&) const { return meshes; }
  const auto& list_of(const PlacedHull<S, 3>&) const { return hulls; }
  const auto& list_of(const PlacedField<S>&) const { return fields; }
  Restored restore(World& scene, std::span<const std::byte> bytes) const {
    return detent::restore(scene, bytes, meshes, hulls, fields);
  }

 private:
  HeightField<S> draw_field(Historian<S, 3>& history) {
    while (true) {
      const auto a = history.point(), b = history.point();
      const auto columns = static_cast<std::uint32_t>(history.random().between(2, 4));
      const auto rows = static_cast<std::uint32_t>(history.random().between(2, 4));
      heights.emplace_back();
      for (std::uint32_t i = 0; i < columns * rows; ++i) {
        heights.back().push_back(history.point().y);
      }
      const auto cell = nearest_to<S>(half(half(abs(a.x - b.x))));
      if (const auto field = height_field<S>({a.x, a.z}, cell, columns, rows, heights.back())) {
        return *field;
      }
    }
  }
};

}  // namespace

TEST_CASE("scene of assets: results equal those of a list of placed hulls, fields and meshes",
          "[scene]") {
  check_balance([](HitRate& rate) {
    for (std::uint64_t seed = 5; seed < 25; ++seed) live<Stock>(seed, 12, 10, 12, rate);
  });
}

TEST_CASE("scene of assets: long histories", "[.demand]") {
  check_balance([](HitRate& rate) {
    for (const auto seed : oracle::demanded_seeds()) live<Stock>(seed, 12, 10, 60, rate);
  });
}

}  // namespace detent::test
