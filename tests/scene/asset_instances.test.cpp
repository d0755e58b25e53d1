// SPDX-License-Identifier: MIT
#include <array>
#include <deque>
#include <map>
#include <optional>
#include <variant>
#include <vector>

#include "detent/scene/height_field.hpp"
#include "detent/scene/hull.hpp"
#include "detent/scene/mesh.hpp"
#include "detent/scene/mesh/owned.hpp"
#include "oracle/seeds.hpp"
#include "scene/histories.hpp"
#include "scene/surface_loop.hpp"

namespace detent::test {
namespace {

using S = q16_16;
using Vec3 = Vec<S, 3>;
using World = AnyScene<S, 3, PlacedMesh<S>, PlacedHull<S, 3>, PlacedField<S>>;
using Local = AnyShape<S, 3, PlacedMesh<S>, PlacedHull<S, 3>, PlacedField<S>>;

/// The assets and the data that they refer to.
struct Stock {
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

/// The transformed points of a hull.
struct PlainHull {
  std::vector<Vec3> points;
};

/// What the scene should hold: shapes in the world, with assets as lists of their parts.
using Shown = AnyShape<S, 3, TriangleLoop<S>, PlainHull>;

template <class Shape>
Shown shown(const Stock& stock, const Shape& shape) {
  if constexpr (std::is_same_v<Shape, PlacedMesh<S>>) {
    TriangleLoop<S> loop;
    if (shape.asset == nullptr) return loop;
    for (const auto& part : stock.triangles[shape.asset->id()]) {
      loop.triangles.push_back(placed(shape.transform, part));
    }
    return loop;
  } else if constexpr (std::is_same_v<Shape, PlacedHull<S, 3>>) {
    PlainHull hull;
    if (shape.asset == nullptr) return hull;
    for (const auto& point : stock.points[shape.asset->id()]) {
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

/// The shape to query for an expected one.
template <class Shape>
const Shape& asked(const Shape& shape) {
  return shape;
}
ConvexHull<S, 3> asked(const PlainHull& hull) { return {hull.points}; }

struct Object {
  ObjectId id;
  Local local;
  Traits traits;
  Shown world{};
};

struct Plain {
  const Stock& stock;
  std::map<std::uint32_t, Object> objects{};
  Transform<S, 3> frame{};

  void show(Object& object) const {
    std::visit(
        [&](const auto& local) {
          const bool is_attached = object.traits.frame != FrameId{};
          object.world = is_attached ? shown(stock, placed(frame, local)) : shown(stock, local);
        },
        object.local);
  }

  template <class Question>
  [[nodiscard]] std::vector<Found<S>> all(const Question& question) const {
    std::vector<Found<S>> list;
    for (const auto& [index, object] : objects) {
      std::visit(
          [&, id = object.id](const auto& world) {
            const auto& shape = asked(world);
            if constexpr (std::is_same_v<Question, Ray<S, 3>>) {
              if (const auto distance = raycast(question, shape)) list.push_back({*distance, id});
            } else if (detail::meets(question, shape)) {
              list.push_back({distance(shape, detail::reference(question)), id});
            }
          },
          object.world);
    }
    std::sort(list.begin(), list.end());
    return list;
  }

  [[nodiscard]] std::vector<Overlap> overlaps() const {
    std::vector<Overlap> list;
    for (auto a = objects.begin(); a != objects.end(); ++a) {
      for (auto b = std::next(a); b != objects.end(); ++b) {
        const auto &one = a->second, &other = b->second;
        if (one.traits.motion == Motion::fixed && other.traits.motion == Motion::fixed) continue;
        const bool meet = std::visit(
            [](const auto& x, const auto& y) { return detail::meets(asked(x), asked(y)); },
            one.world, other.world);
        if (meet) list.push_back({one.id, other.id});
      }
    }
    return list;
  }
};

Transform<S, 3> draw_transform(Historian<S, 3>& history) {
  auto& random = history.random();
  Transform<S, 3> transform;
  if (random.coin()) transform.translation = nearest_to<S>(history.point() - history.point());
  if (random.one_in(3)) transform.rotation = history.draw<Obb<S, 3>>().rotation;
  if (random.one_in(6)) transform.scale = S(-2);
  return transform;
}

Local draw_local(Historian<S, 3>& history, const Stock& stock) {
  auto& random = history.random();
  const auto at = random.below(3);
  const auto transform = draw_transform(history);
  switch (random.below(9)) {
    case 0:
    case 1:
    case 2:
      return PlacedHull<S, 3>{random.one_in(9) ? nullptr : &stock.hulls[at], transform};
    case 3:
    case 4:
      return PlacedField<S>{random.one_in(9) ? nullptr : &stock.fields[at], transform.translation};
    case 5:
      return PlacedMesh<S>{&stock.meshes[at], transform};
    default:
      return support::SceneShapes<S, 3>::at(
          random.below(support::SceneShapes<S, 3>::size),
          [&]<class Shape>(const Shape&) -> Local { return history.draw<Shape>(); });
  }
}

template <class Question>
void ask(const World& scene, const Plain& plain, const Question& question, HitRate& rate) {
  const auto expected = plain.all(question);
  rate.count(!expected.empty());
  REQUIRE(scene.all(question) == expected);
  REQUIRE(scene.any(question) == !expected.empty());
  if constexpr (!std::is_same_v<Question, Vec3>) {
    REQUIRE(scene.nearest(question) ==
            (expected.empty() ? std::nullopt : std::optional(expected.front())));
  }
}

/// Adds, changes, moves or removes an object at a random index.
void step(Historian<S, 3>& history, World& scene, Plain& plain, const FrameId& frame) {
  auto& random = history.random();
  const auto index = static_cast<std::uint32_t>(random.below(12));
  const auto at = plain.objects.find(index);
  if (at == plain.objects.end()) {
    Object object{{index, static_cast<std::uint32_t>(2 + random.below(1000))},
                  draw_local(history, plain.stock),
                  {}};
    if (random.one_in(4)) {
      object.traits.motion = Motion::fixed;
    } else if (random.one_in(3)) {
      object.traits.frame = frame;
    }
    REQUIRE(std::visit([&](const auto& s) { return scene.add_as(object.id, s, object.traits); },
                       object.local));
    plain.show(object);
    plain.objects.emplace(index, object);
    return;
  }
  auto& object = at->second;
  if (random.one_in(4)) {
    REQUIRE(scene.remove(object.id));
    plain.objects.erase(at);
    return;
  }
  if (object.traits.motion == Motion::fixed) return;
  if (random.coin()) {
    object.local = draw_local(history, plain.stock);
    REQUIRE(
        std::visit([&](const auto& s) { return scene.replace_local(object.id, s); }, object.local));
  } else {
    const auto by = nearest_to<S>(history.point() - history.point());
    REQUIRE(scene.move(object.id, by));
    object.local =
        std::visit([&](const auto& s) { return Local(translated(s, by)); }, object.local);
  }
  plain.show(object);
}

/// A scene of the same objects, added in index order, with copies of the assets.
World fresh(const Plain& plain, const FrameId& frame, const Stock& copies) {
  World scene;
  REQUIRE(scene.add_frame(plain.frame) == frame);
  for (const auto& [index, object] : plain.objects) {
    std::visit(
        [&, id = object.id, traits = object.traits](auto shape) {
          const auto swap = [](auto& asset, const auto& list) {
            if (asset) asset = &list[asset->id()];
          };
          using Shape = decltype(shape);
          if constexpr (std::is_same_v<Shape, PlacedMesh<S>>) swap(shape.asset, copies.meshes);
          if constexpr (std::is_same_v<Shape, PlacedHull<S, 3>>) swap(shape.asset, copies.hulls);
          if constexpr (std::is_same_v<Shape, PlacedField<S>>) swap(shape.asset, copies.fields);
          REQUIRE(scene.add_as(id, shape, traits));
        },
        object.local);
  }
  return scene;
}

void live(std::uint64_t seed, int checks, HitRate& rate) {
  constexpr std::array kinds{oracle::Kind::general, oracle::Kind::lattice, oracle::Kind::tiny,
                             oracle::Kind::extreme, oracle::Kind::degenerate};
  for (const auto kind : kinds) {
    INFO("seed " << seed << ", kind " << static_cast<int>(kind));
    Historian<S, 3> history(seed, kind);
    const Stock stock(history);
    const Stock copies = stock;
    World scene;
    Plain plain{stock};
    const auto frame = *scene.add_frame({});
    for (int i = 0; i < checks; ++i) {
      for (int k = 0; k < 10; ++k) step(history, scene, plain, frame);
      plain.frame = draw_transform(history);
      REQUIRE(scene.move_frame(frame, plain.frame));
      for (auto& [index, object] : plain.objects) plain.show(object);
      REQUIRE(scene.overlaps() == plain.overlaps());
      for (int k = 0; k < 2; ++k) {
        ask(scene, plain, history.ray(), rate);
        ask(scene, plain, history.point(), rate);
        QueryShapes<S, 3>::for_each(
            [&]<class Shape>(const Shape&) { ask(scene, plain, history.draw<Shape>(), rate); });
        ask(scene, plain, history.frustum(), rate);
      }
      auto other = fresh(plain, frame, copies);
      REQUIRE(digest(scene) == digest(other));
      const auto bytes = snapshot(scene);
      REQUIRE(restore(other, bytes, copies.meshes, copies.hulls, copies.fields) == Restored::yes);
      REQUIRE(snapshot(other) == bytes);
      REQUIRE(other.overlaps() == plain.overlaps());
    }
  }
}

}  // namespace

TEST_CASE("scene of assets: results equal those of a list of placed hulls, fields and meshes",
          "[scene]") {
  HitRate rate;
  for (std::uint64_t seed = 5; seed < 25; ++seed) live(seed, 12, rate);
  INFO(rate);
  CHECK(rate.is_balanced());
}

TEST_CASE("scene of assets: long histories", "[.demand]") {
  HitRate rate;
  for (const auto seed : oracle::demanded_seeds()) live(seed, 60, rate);
  INFO(rate);
  CHECK(rate.is_balanced());
}

}  // namespace detent::test
