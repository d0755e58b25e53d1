// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "detent/scene/snapshot.hpp"
#include "oracle/draw_shape.hpp"
#include "oracle/frustum.hpp"
#include "oracle/space.hpp"
#include "scene/any_scene.hpp"
#include "support/catch.hpp"

/// One scalar per width and dimension: a scene instantiates every query of the library, which is
/// slow to compile.
#define DETENT_SCENE_SPACES \
  (detent::test::Space<detent::q16_16, 3>), (detent::test::Space<detent::q8_8, 2>)

namespace detent::test {

/// The shape to query for one in a list.
template <class Shape>
const Shape& asked(const Shape& shape) {
  return shape;
}

/// A plain list of objects by index, whose queries test each `shape`.
template <Scalar S, int N, class Object>
struct PlainList {
  std::map<std::uint32_t, Object> objects{};

  template <class Question>
  std::vector<Found<S>> all(const Question& question, std::uint32_t mask = ~0u) const {
    std::vector<Found<S>> list;
    for (const auto& [index, object] : objects) {
      if ((object.traits.layers & mask) == 0) continue;
      std::visit(
          [&, id = object.id](const auto& listed) {
            const auto& shape = asked(listed);
            if constexpr (std::is_same_v<Question, Ray<S, N>>) {
              const auto distance = raycast(question, shape);
              if (distance) list.push_back({*distance, id});
            } else if (detail::meets(question, shape)) {
              list.push_back({distance(shape, detail::reference(question)), id});
            }
          },
          object.shape);
    }
    std::sort(list.begin(), list.end());
    return list;
  }

  std::vector<Overlap> overlaps() const {
    std::vector<Overlap> list;
    for (auto a = objects.begin(); a != objects.end(); ++a) {
      for (auto b = std::next(a); b != objects.end(); ++b) {
        const auto &one = a->second, &other = b->second;
        if (one.traits.motion == Motion::fixed && other.traits.motion == Motion::fixed) continue;
        const bool meet = std::visit(
            [](const auto& x, const auto& y) { return detail::meets(asked(x), asked(y)); },
            one.shape, other.shape);
        if (meet) list.push_back({one.id, other.id});
      }
    }
    return list;
  }
};

template <Scalar S, int N>
struct PlainObject {
  ObjectId id;
  AnyShape<S, N> shape;
  Traits traits;
};

/// What a scene should hold.
template <Scalar S, int N>
struct PlainScene : PlainList<S, N, PlainObject<S, N>> {
  using PlainList<S, N, PlainObject<S, N>>::objects;

  /// Skips empty objects, for which `distance` returns the greatest number.
  std::optional<Found<S>> nearest(const Vec<S, N>& point, std::uint32_t mask) const {
    std::optional<Found<S>> best;
    for (const auto& [index, object] : objects) {
      const bool none = std::visit(
          [](const auto& shape) { return detail::quantized_box(shape).is_empty(); }, object.shape);
      if (none || (object.traits.layers & mask) == 0) continue;
      const Found<S> found{
          std::visit([&](const auto& shape) { return distance(shape, point); }, object.shape),
          object.id};
      if (!best || found < *best) best = found;
    }
    return best;
  }

  /// A scene of the same objects, added in index order.
  AnyScene<S, N> fresh() const {
    AnyScene<S, N> scene;
    for (const auto& [index, object] : objects) {
      std::visit([&, id = object.id,
                  traits = object.traits](const auto& shape) { scene.add_as(id, shape, traits); },
                 object.shape);
    }
    return scene;
  }
};

/// Draws objects and queries of one kind, and changes to a scene.
template <Scalar S, int N>
class Historian {
 public:
  using Shape = AnyShape<S, N>;

  Historian(std::uint64_t seed, oracle::Kind kind)
      : draw_(seed),
        setting_(oracle::draw_setting(draw_, kind, kind == oracle::Kind::general ? 400 : 100)) {}

  Random& random() { return draw_.random; }

  template <class T>
  T draw() {
    return oracle::draw_shape<T>(draw_, setting_);
  }
  Vec<S, N> point() { return draw<Sphere<S, N>>().center; }
  Shape shape() {
    using Shapes = support::SceneShapes<S, N>;
    const auto kind = random().below(random().one_in(4) ? Shapes::size : 3);
    return Shapes::at(kind, [&]<class T>(const T&) { return Shape(draw<T>()); });
  }
  Frustum<S> frustum() requires(N == 3) {
    oracle::Artist<S, 3> artist(draw_, setting_);
    return oracle::draw_frustum(artist);
  }
  Ray<S, N> ray() {
    Ray<S, N> ray{point(), draw_.any_direction(), largest<S>};
    if (const auto toward = normalize(nearest_to<S>(point() - ray.origin));
        toward && random().coin()) {
      ray.direction = *toward;
    }
    if (random().one_in(3)) ray.max_distance = distance(ray.origin, point());
    return ray;
  }

  /// Applies one addition, removal or change to a scene and to the list.
  void step(AnyScene<S, N>& scene, PlainScene<S, N>& plain, std::size_t room) {
    const auto index = static_cast<std::uint32_t>(random().below(room));
    const auto at = plain.objects.find(index);
    if (at == plain.objects.end()) {
      const ObjectId id{index, static_cast<std::uint32_t>(1 + random().below(1000))};
      const Traits traits{static_cast<std::uint32_t>(1 + random().below(7)),
                          random().next(),
                          random().one_in(3) ? Motion::fixed : Motion::moving,
                          {}};
      const auto added = shape();
      CHECK(std::visit([&](const auto& s) { return scene.add_as(id, s, traits); }, added));
      plain.objects[index] = {id, added, traits};
      return;
    }
    auto& object = at->second;
    switch (random().below(5)) {
      case 0:
        CHECK(scene.remove(object.id));
        plain.objects.erase(at);
        break;
      case 1: {
        object.shape = shape();
        CHECK(std::visit([&](const auto& s) { return scene.replace(object.id, s); }, object.shape));
        break;
      }
      case 2:
        object.traits.layers = static_cast<std::uint32_t>(1 + random().below(7));
        CHECK(scene.set_layers(object.id, object.traits.layers));
        break;
      default: {
        auto by = nearest_to<S>(point() - point());
        if (random().coin()) {
          for (int i = 0; i < N; ++i) by[i] = quotient_nearest<S>(by[i], S(16));
        }
        CHECK(scene.move(object.id, by));
        object.shape =
            std::visit([&](const auto& s) { return Shape(translated(s, by)); }, object.shape);
      }
    }
  }

 private:
  oracle::Draw<S, N> draw_;
  oracle::Setting<N> setting_;
};

}  // namespace detent::test
