// SPDX-License-Identifier: MIT
#include "detent/scene/mesh/instance.hpp"

#include <array>
#include <deque>
#include <map>
#include <variant>
#include <vector>

#include "oracle/seeds.hpp"
#include "scene/histories.hpp"
#include "scene/mesh_helpers.hpp"
#include "scene/surface_loop.hpp"

namespace detent::test {
namespace {

using S = q16_16;
using Ball = Sphere<S, 3>;
using Placed = PlacedMesh<S>;
using Assets = std::vector<MeshAsset<S>>;
using World = Scene<S, 3, Sphere, Plane, MeshInstance>;

/// Meshes of few triangles, and their triangles in the order drawn.
struct Meshes {
  std::vector<std::vector<Triangle<S, 3>>> lists;
  std::deque<OwnedMesh<S>> owned;
  Assets assets;

  void add(std::uint32_t id, const std::vector<Triangle<S, 3>>& triangles) {
    lists.push_back(triangles);
    owned.emplace_back(std::span<const Triangle<S, 3>>(triangles));
    assets.emplace_back(id, owned.back().view());
  }
  [[nodiscard]] std::size_t index_of(const Placed& mesh) const {
    return static_cast<std::size_t>(mesh.asset - assets.data());
  }
};

/// The expected contents: each object in world space, with meshes as lists of triangles.
class PlainWorld {
 public:
  using Shape = std::variant<Ball, Plane<S, 3>, Placed>;
  struct Object {
    ObjectId id;
    Shape local;
    Traits traits;
    std::variant<Ball, Plane<S, 3>, TriangleLoop<S>> world{};
  };
  std::map<std::uint32_t, Object> objects;
  Transform<S, 3> frame{};
  const Meshes& meshes;

  explicit PlainWorld(const Meshes& all) : meshes(all) {}

  void place(Object& object) const {
    const bool is_attached = object.traits.frame != FrameId{};
    std::visit(
        [&](const auto& local) {
          const auto shape = is_attached ? placed(frame, local) : local;
          if constexpr (std::is_same_v<decltype(shape), const Placed>) {
            object.world = loop_of(shape);
          } else {
            object.world = shape;
          }
        },
        object.local);
  }
  void place_all() {
    for (auto& [index, object] : objects) place(object);
  }

  template <class Question>
  std::vector<Found<S>> all(const Question& question) const {
    std::vector<Found<S>> list;
    for (const auto& [index, object] : objects) {
      std::visit(
          [&, id = object.id](const auto& shape) {
            if constexpr (std::is_same_v<Question, Ray<S, 3>>) {
              const auto distance = raycast(question, shape);
              if (distance) list.push_back({*distance, id});
            } else if (detail::meets(question, shape)) {
              list.push_back({distance(shape, detail::reference(question)), id});
            }
          },
          object.world);
    }
    std::sort(list.begin(), list.end());
    return list;
  }

  std::vector<Overlap> overlaps() const {
    std::vector<Overlap> list;
    for (auto a = objects.begin(); a != objects.end(); ++a) {
      for (auto b = std::next(a); b != objects.end(); ++b) {
        const auto &first = a->second, &second = b->second;
        if (first.traits.motion == Motion::fixed && second.traits.motion == Motion::fixed) continue;
        if (std::visit([](const auto& x, const auto& y) { return detail::meets(x, y); },
                       first.world, second.world)) {
          list.push_back({first.id, second.id});
        }
      }
    }
    return list;
  }

 private:
  TriangleLoop<S> loop_of(const Placed& mesh) const {
    TriangleLoop<S> loop;
    if (mesh.asset == nullptr) return loop;
    for (const auto& triangle : meshes.lists[meshes.index_of(mesh)]) {
      loop.triangles.push_back(placed(mesh.transform, triangle));
    }
    return loop;
  }
};

template <class Question>
void ask(const World& scene, const PlainWorld& plain, const Question& question, HitRate& rate) {
  const auto expected = plain.all(question);
  rate.count(!expected.empty());
  CHECK(scene.all(question) == expected);
  CHECK(scene.any(question) == !expected.empty());
  if constexpr (!std::is_same_v<Question, Vec<S, 3>>) {
    CHECK(scene.nearest(question) ==
          (expected.empty() ? std::nullopt : std::optional(expected.front())));
  }
}

Transform<S, 3> draw_transform(Historian<S, 3>& history) {
  Transform<S, 3> transform;
  if (history.random().coin())
    transform.translation = nearest_to<S>(history.point() - history.point());
  if (history.random().one_in(3)) transform.rotation = history.draw<Obb<S, 3>>().rotation;
  if (history.random().one_in(6)) transform.scale = S(-2);
  return transform;
}

PlainWorld::Shape draw_shape(Historian<S, 3>& history, const Meshes& meshes) {
  switch (history.random().below(12)) {
    case 0:
      return history.draw<Plane<S, 3>>();
    case 1:
    case 2:
    case 3:
      return history.draw<Ball>();
    default:
      if (history.random().one_in(20)) return Placed();
      return Placed{&meshes.assets[history.random().below(meshes.assets.size())],
                    draw_transform(history)};
  }
}

void step(Historian<S, 3>& history, World& scene, PlainWorld& plain, const FrameId& frame,
          std::size_t room) {
  auto& random = history.random();
  const auto index = static_cast<std::uint32_t>(random.below(room));
  const auto at = plain.objects.find(index);
  if (at == plain.objects.end()) {
    PlainWorld::Object object{{index, static_cast<std::uint32_t>(2 + random.below(1000))},
                              draw_shape(history, plain.meshes),
                              {}};
    if (random.one_in(3)) {
      object.traits.motion = Motion::fixed;
    } else if (random.one_in(3)) {
      object.traits.frame = frame;
    }
    CHECK(std::visit([&](const auto& s) { return scene.add_as(object.id, s, object.traits); },
                     object.local));
    plain.place(object);
    plain.objects.emplace(index, object);
    return;
  }
  auto& object = at->second;
  switch (random.below(4)) {
    case 0:
      CHECK(scene.remove(object.id));
      plain.objects.erase(at);
      return;
    case 1:
      object.local = draw_shape(history, plain.meshes);
      CHECK(std::visit([&](const auto& s) { return scene.replace_local(object.id, s); },
                       object.local));
      break;
    default: {
      const auto by = nearest_to<S>(history.point() - history.point());
      CHECK(scene.move(object.id, by));
      object.local = std::visit([&](const auto& s) { return PlainWorld::Shape(translated(s, by)); },
                                object.local);
    }
  }
  plain.place(object);
}

/// A scene of the same objects, added in index order, with copies of the meshes.
World fresh(const PlainWorld& plain, const FrameId& frame, const Assets& copies) {
  World scene;
  CHECK(scene.add_frame(plain.frame) == frame);
  for (const auto& [index, object] : plain.objects) {
    std::visit(
        [&, id = object.id, traits = object.traits](auto shape) {
          if constexpr (std::is_same_v<decltype(shape), Placed>) {
            if (shape.asset) shape.asset = &copies[plain.meshes.index_of(shape)];
          }
          scene.add_as(id, shape, traits);
        },
        object.local);
  }
  return scene;
}

void live(std::uint64_t seed, std::size_t room, int steps, int checks, HitRate& rate) {
  constexpr std::array kinds{oracle::Kind::general, oracle::Kind::lattice, oracle::Kind::tiny,
                             oracle::Kind::extreme, oracle::Kind::degenerate};
  for (const auto kind : kinds) {
    INFO("seed " << seed << ", kind " << static_cast<int>(kind));
    Historian<S, 3> history(seed, kind);
    Meshes meshes;
    for (std::uint32_t id = 0; id < 4; ++id) {
      std::vector<Triangle<S, 3>> triangles(history.random().below(14));
      for (auto& triangle : triangles) triangle = history.draw<Triangle<S, 3>>();
      meshes.add(id, triangles);
    }
    const Assets copies = meshes.assets;
    World scene;
    PlainWorld plain(meshes);
    const auto frame = *scene.add_frame({});
    for (int i = 0; i < checks; ++i) {
      for (int k = 0; k < steps; ++k) step(history, scene, plain, frame, room);
      plain.frame = draw_transform(history);
      CHECK(scene.move_frame(frame, plain.frame));
      plain.place_all();
      CHECK(scene.overlaps() == plain.overlaps());
      for (int k = 0; k < 3; ++k) {
        ask(scene, plain, history.ray(), rate);
        ask(scene, plain, history.point(), rate);
        QueryShapes<S, 3>::for_each(
            [&]<class Shape>(const Shape&) { ask(scene, plain, history.draw<Shape>(), rate); });
      }
      auto other = fresh(plain, frame, copies);
      CHECK(digest(scene) == digest(other));
      const auto bytes = snapshot(scene);
      REQUIRE(restore(other, bytes, copies) == Restored::yes);
      CHECK(snapshot(other) == bytes);
      CHECK(other.overlaps() == plain.overlaps());
    }
  }
}

}  // namespace

TEST_CASE("mesh instance: results equal those of a list of placed triangles, after any history") {
  HitRate rate;
  live(3, 16, 60, 6, rate);
  INFO(rate);
  CHECK(rate.is_balanced());
}

TEST_CASE("mesh instance: long histories", "[.demand]") {
  HitRate rate;
  for (const auto seed : oracle::demanded_seeds()) live(seed, 24, 200, 12, rate);
  INFO(rate);
  CHECK(rate.is_balanced());
}

}  // namespace detent::test
