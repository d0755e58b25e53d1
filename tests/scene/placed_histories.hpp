// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <variant>

#include "detent/scene/mesh.hpp"
#include "oracle/seeds.hpp"
#include "scene/histories.hpp"
#include "scene/mesh_helpers.hpp"
#include "scene/surface_loop.hpp"

// Random histories of scenes whose objects refer to assets and follow a frame, against lists of
// what these objects are in the world. A `Stock` has the assets: it draws objects (`Local`) and
// shows them as shapes of the list (`Shown`).
namespace detent::test {

template <class Local, class Shown>
struct PlacedObject {
  ObjectId id;
  Local local;
  Traits traits;
  Shown shape{};
};

/// What a scene should hold.
template <class Stock>
struct PlacedList
    : PlainList<q16_16, 3, PlacedObject<typename Stock::Local, typename Stock::Shown>> {
  explicit PlacedList(const Stock& all) : stock(all) {}

  const Stock& stock;
  Transform<q16_16, 3> frame{};

  template <class Object>
  void show(Object& object) const {
    const bool is_attached = object.traits.frame != FrameId{};
    std::visit(
        [&](const auto& local) {
          object.shape = stock.shown(is_attached ? placed(frame, local) : local);
        },
        object.local);
  }
};

inline Transform<q16_16, 3> draw_transform(Historian<q16_16, 3>& history) {
  auto& random = history.random();
  Transform<q16_16, 3> transform;
  if (random.coin()) transform.translation = nearest_to<q16_16>(history.point() - history.point());
  if (random.one_in(3)) transform.rotation = history.draw<Obb<q16_16, 3>>().rotation;
  if (random.one_in(6)) transform.scale = q16_16(-2);
  return transform;
}

/// The triangles of a mesh, given those of every asset by id.
template <class Lists>
TriangleLoop<q16_16> loop_of(const PlacedMesh<q16_16>& mesh, const Lists& lists) {
  TriangleLoop<q16_16> loop;
  if (mesh.asset == nullptr) return loop;
  for (const auto& triangle : lists[mesh.asset->id()]) {
    loop.triangles.push_back(placed(mesh.transform, triangle));
  }
  return loop;
}

/// Adds, changes, moves or removes an object at a random index.
template <class Stock>
void step(Historian<q16_16, 3>& history, typename Stock::World& scene, PlacedList<Stock>& plain,
          const FrameId& frame, std::size_t room) {
  auto& random = history.random();
  const auto index = static_cast<std::uint32_t>(random.below(room));
  const auto at = plain.objects.find(index);
  if (at == plain.objects.end()) {
    auto& object = plain.objects[index];
    object.id = {index, static_cast<std::uint32_t>(2 + random.below(1000))};
    object.local = plain.stock.draw(history);
    if (random.one_in(3)) {
      object.traits.motion = Motion::fixed;
    } else if (random.one_in(3)) {
      object.traits.frame = frame;
    }
    REQUIRE(std::visit([&](const auto& s) { return scene.add_as(object.id, s, object.traits); },
                       object.local));
    plain.show(object);
    return;
  }
  auto& object = at->second;
  switch (random.below(4)) {
    case 0:
      REQUIRE(scene.remove(object.id));
      plain.objects.erase(at);
      return;
    case 1:
      object.local = plain.stock.draw(history);
      REQUIRE(std::visit([&](const auto& s) { return scene.replace_local(object.id, s); },
                         object.local));
      break;
    default: {
      const auto by = nearest_to<q16_16>(history.point() - history.point());
      REQUIRE(scene.move(object.id, by));
      object.local = std::visit(
          [&](const auto& s) { return typename Stock::Local(translated(s, by)); }, object.local);
    }
  }
  plain.show(object);
}

/// A scene of the same objects, added in index order, with the assets of a copy of the stock.
template <class Stock>
typename Stock::World fresh(const PlacedList<Stock>& plain, const FrameId& frame,
                            const Stock& copies) {
  typename Stock::World scene;
  REQUIRE(scene.add_frame(plain.frame) == frame);
  for (const auto& [index, object] : plain.objects) {
    std::visit(
        [&, id = object.id, traits = object.traits](auto shape) {
          if constexpr (requires { shape.asset; }) {
            if (shape.asset) shape.asset = &copies.list_of(shape)[shape.asset->id()];
          }
          REQUIRE(scene.add_as(id, shape, traits));
        },
        object.local);
  }
  return scene;
}

template <class Stock, class Question>
void ask(const typename Stock::World& scene, const PlacedList<Stock>& plain,
         const Question& question, HitRate& rate) {
  const auto expected = plain.all(question);
  rate.count(!expected.empty());
  check_all(scene, question, InLayers{~0u}, expected);
}

/// Histories of up to `room` objects, with `steps` changes before each of the checks.
template <class Stock>
void live(std::uint64_t seed, std::size_t room, int steps, int checks, HitRate& rate) {
  for (const auto kind : oracle::every_kind) {
    INFO("seed " << seed << ", kind " << static_cast<int>(kind));
    Historian<q16_16, 3> history(seed, kind);
    const Stock stock(history);
    const Stock copies = stock;
    typename Stock::World scene;
    PlacedList<Stock> plain(stock);
    const auto frame = *scene.add_frame({});
    for (int i = 0; i < checks; ++i) {
      for (int k = 0; k < steps; ++k) step(history, scene, plain, frame, room);
      plain.frame = draw_transform(history);
      REQUIRE(scene.move_frame(frame, plain.frame));
      for (auto& [index, object] : plain.objects) plain.show(object);
      REQUIRE(scene.overlaps() == plain.overlaps());
      for (int k = 0; k < 2; ++k) {
        ask(scene, plain, history.ray(), rate);
        ask(scene, plain, history.point(), rate);
        QueryShapes<q16_16, 3>::for_each(
            [&]<class Shape>(const Shape&) { ask(scene, plain, history.draw<Shape>(), rate); });
        ask(scene, plain, history.frustum(), rate);
      }
      auto other = fresh(plain, frame, copies);
      REQUIRE(digest(scene) == digest(other));
      const auto bytes = snapshot(scene);
      REQUIRE(copies.restore(other, bytes) == Restored::yes);
      REQUIRE(snapshot(other) == bytes);
      REQUIRE(other.overlaps() == plain.overlaps());
    }
  }
}

}  // namespace detent::test
