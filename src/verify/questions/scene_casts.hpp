// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "verify/questions/casts.hpp"
#include "verify/questions/listed.hpp"
#include "verify/questions/walks.hpp"

// Capsules that move through scenes, of the type in which characters walk: to compile faster.

namespace detent::verify {

template <Scalar S, int N>
struct SceneCastCase {
  static constexpr std::size_t size = 5;

  std::array<Aabb<S, N>, size> boxes{};
  std::array<std::uint32_t, size> layers{};
  std::uint32_t fixed = 0;  // bit i for box i
  std::uint32_t mask = 0;
  Cast<Capsule<S, N>> moving{};

  constexpr auto fields(const auto& f) const noexcept {
    return f(boxes, layers, fixed, mask, moving);
  }
};

/// The boxes that a moving capsule touches, in some layers.
struct SceneCasts : InDimensions<2, 3> {
  static constexpr std::array<std::string_view, 3> names{"scene/nearest/cast", "scene/any/cast",
                                                         "scene/all/cast"};
  static constexpr std::uint32_t share = 24;

  template <Scalar S, int N>
  static constexpr auto draw(Random& random) noexcept {
    ShapeScene<S, N> scene(random);
    SceneCastCase<S, N> c;
    for (std::size_t i = 0; i < c.size; ++i) {
      c.boxes[i] = scene.aabb();
      c.layers[i] = static_cast<std::uint32_t>(random.between(1, 7));
      scene.wander();
      if (random.coin()) scene.turn();
    }
    c.fixed = static_cast<std::uint32_t>(random.below(1u << c.size));
    c.mask = static_cast<std::uint32_t>(random.below(8));
    if (random.coin()) scene.go_home();
    c.moving = drawn_cast<Capsule>(scene);
    return c;
  }
  template <int Row, Scalar S, int N>
  [[nodiscard]] static constexpr auto answer(const SceneCastCase<S, N>& c) noexcept {
    BoxScene<S, N> scene;
    for (std::size_t i = 0; i < c.size; ++i) {
      const bool is_fixed = (c.fixed >> i & 1u) != 0;
      scene.add(c.boxes[i],
                Traits{.layers = c.layers[i], .motion = is_fixed ? Motion::fixed : Motion::moving});
    }
    const InLayers filter{c.mask};
    if constexpr (Row == 0) {
      return scene.nearest(c.moving, filter);
    } else if constexpr (Row == 1) {
      return scene.any(c.moving, filter);
    } else {
      return list_all<Found<S>, 3>(scene, c.moving, filter);
    }
  }
};

}  // namespace detent::verify
