// SPDX-License-Identifier: MIT
#pragma once

#include "c/movers.hpp"

namespace detent::c {

template <int N, template <class, int> class Shape>
MoveResult<S, N> MoverOf<N, Shape>::move(const SceneType<N>& scene, Mover<S, N, Shape>& mover,
                                         const Vec<S, N>& by, const MoverSettings<S, N>& settings,
                                         const OthersInLayers& filter) {
  return mover.move(scene, by, settings, filter);
}
template <int N, template <class, int> class Shape>
std::optional<ObjectHit<S, N>> SceneCastOf<N, Shape>::nearest(const SceneType<N>& scene,
                                                              const Moving& moving,
                                                              InLayers layers) {
  return scene.nearest_hit(moving, layers);
}
template <int N, template <class, int> class Shape>
bool SceneCastOf<N, Shape>::any(const SceneType<N>& scene, const Moving& moving, InLayers layers) {
  return scene.any(moving, layers);
}
template <int N, template <class, int> class Shape>
std::size_t SceneCastOf<N, Shape>::all(const SceneType<N>& scene, const Moving& moving,
                                       std::span<ObjectHit<S, N>> room, InLayers layers) {
  return scene.all_hits(moving, room, layers);
}

}  // namespace detent::c
