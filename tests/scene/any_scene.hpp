// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <type_traits>
#include <variant>
#include <vector>

#include "detent/scene/scene.hpp"
#include "support/catch.hpp"
#include "support/shapes.hpp"

namespace detent::test {

template <Scalar S, int N>
struct SceneOf {
  template <class... Shapes>
  using type = BasicScene<Growing, S, N, Shapes...>;
};

/// A growing scene of all kinds of shapes, and of `More`.
template <Scalar S, int N, class... More>
using AnyScene =
    typename support::SceneShapes<S, N>::template in<SceneOf<S, N>::template type, More...>;

/// One of its shapes.
template <Scalar S, int N, class... More>
using AnyShape = typename support::SceneShapes<S, N>::template in<std::variant, More...>;

/// The shapes with which scenes are queried.
template <Scalar S, int N>
using QueryShapes = typename support::AllShapes<S, N>::template without<Plane<S, N>, Triangle<S, N>,
                                                                        ConvexHull<S, N>>;

/// Adds one of each shape that scenes hold, drawn by `draw(Shape())`, each in the next layer: the
/// oriented box in a frame, the triangle at rest. Returns the layer after them.
template <class Scene, class Draw, Scalar S, int N>
std::uint32_t add_one_of_each(Scene& scene, const Draw& draw, const FrameId& frame,
                              const Vec<S, N>& /* names the space */) {
  std::uint32_t layer = 1;
  support::SceneShapes<S, N>::for_each([&]<class Shape>(const Shape& any) {
    Traits traits{.layers = layer};
    if (std::is_same_v<Shape, Obb<S, N>>) traits.frame = frame;
    if (std::is_same_v<Shape, Triangle<S, N>>) traits.motion = Motion::fixed;
    scene.add(draw(any), traits);
    layer *= 2;
  });
  return layer;
}

/// Compares what a scene finds with a list, nearest first, whole and cut off. The nearest object of
/// a point may be none of those that contain it.
template <class Scene, class Question, Scalar S>
void check_all(const Scene& scene, const Question& question, const InLayers& filter,
               const std::vector<Found<S>>& expected) {
  CHECK(scene.all(question, filter) == expected);
  CHECK(scene.any(question, filter) == !expected.empty());
  if constexpr (!requires { question.x; }) {
    CHECK(scene.nearest(question, filter) ==
          (expected.empty() ? std::nullopt : std::optional(expected.front())));
  }
  std::array<Found<S>, 3> room;
  CHECK(scene.all(question, std::span(room), filter) == expected.size());
  CHECK(std::equal(room.begin(), room.begin() + std::min<std::ptrdiff_t>(3, std::ssize(expected)),
                   expected.begin()));
}
/// The same for hits.
template <class Scene, class Question, Scalar S, int N>
void check_hits(const Scene& scene, const Question& question, const InLayers& filter,
                const std::vector<ObjectHit<S, N>>& expected) {
  CHECK(scene.all_hits(question, filter) == expected);
  CHECK(scene.nearest_hit(question, filter) ==
        (expected.empty() ? std::nullopt : std::optional(expected.front())));
  std::array<ObjectHit<S, N>, 2> room;
  CHECK(scene.all_hits(question, std::span(room), filter) == expected.size());
  CHECK(std::equal(room.begin(), room.begin() + std::min<std::ptrdiff_t>(2, std::ssize(expected)),
                   expected.begin()));
}

}  // namespace detent::test
