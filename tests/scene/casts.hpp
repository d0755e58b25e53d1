// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <variant>
#include <vector>

#include "detent/query/cast.hpp"
#include "scene/histories.hpp"

namespace detent::test {

template <Scalar S, int N, class Shape>
std::vector<Found<S>> touched(const PlainScene<S, N>& plain, const Cast<Shape>& moving,
                              std::uint32_t mask) {
  std::vector<Found<S>> list;
  for (const auto& [index, object] : plain.objects) {
    if ((object.traits.layers & mask) == 0) continue;
    const auto distance = std::visit(
        [&](const auto& shape) {
          return detail::cast_distance(moving.shape, moving.direction, moving.max_distance, shape);
        },
        object.shape);
    if (distance) list.push_back({*distance, object.id});
  }
  std::sort(list.begin(), list.end());
  return list;
}

template <Scalar S, int N, class Shape>
std::vector<Found<S>> ask_cast(const AnyScene<S, N>& scene, const PlainScene<S, N>& plain,
                               const Cast<Shape>& moving, std::uint32_t mask) {
  const auto expected = touched(plain, moving, mask);
  check_all(scene, moving, InLayers{mask}, expected);
  return expected;
}

/// A shape that moves from one object's position towards another's.
template <class Shape, Scalar S, int N>
Cast<Shape> draw_cast(Historian<S, N>& history) {
  const auto ray = history.ray();
  const bool is_short = history.random().one_in(3);
  return {history.template draw<Shape>(), ray.direction,
          is_short ? nearest_to<S>(half(half(half(ray.max_distance)))) : ray.max_distance};
}

template <class Shape, Scalar S, int N>
void check_casts(const AnyScene<S, N>& scene, const PlainScene<S, N>& plain,
                 Historian<S, N>& history, HitRate& rate) {
  for (int i = 0; i < 6; ++i) {
    const auto mask = static_cast<std::uint32_t>(1 + history.random().below(7));
    auto moving = draw_cast<Shape>(history);
    const auto expected = ask_cast(scene, plain, moving, mask);
    rate.count(!expected.empty());
    if (expected.empty()) continue;
    // At the last distance and one step farther: among equal distances, the least id.
    moving.max_distance = expected.back().distance;
    ask_cast(scene, plain, moving, mask);
    moving.max_distance = next_up(moving.max_distance);
    ask_cast(scene, plain, moving, mask);
  }
}

/// Compares casts through a scene, in the middle of its history, with casts at each object.
template <Scalar S, int N, class... Shapes>
void live_and_cast(std::uint64_t seed, std::size_t room, int steps, int checks) {
  HitRate rate;
  for (const auto kind : oracle::every_kind) {
    INFO("seed " << seed << ", kind " << static_cast<int>(kind));
    Historian<S, N> history(seed, kind);
    AnyScene<S, N> scene;
    PlainScene<S, N> plain;
    for (int i = 0; i < checks; ++i) {
      for (int step = 0; step < steps; ++step) history.step(scene, plain, room);
      if (i % 3 == 2) scene.optimize();
      (check_casts<Shapes>(scene, plain, history, rate), ...);
    }
  }
  INFO(rate);
  CHECK(rate.percent() >= 30);
  CHECK(rate.percent() < 97);
}

}  // namespace detent::test
