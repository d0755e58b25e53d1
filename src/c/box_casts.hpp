// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "c/casts.hpp"
#include "detent/scene/hull/placed.hpp"
#include "detent/scene/scene.hpp"

// Casts of boxes against the objects of scenes, through those of src/c/casts/: the distance is
// taken from the hit, so that each pair is compiled once.

namespace detent::c {

/// A hull of a scene, as its points.
template <int N, class F>
auto as_points(const PlacedHull<S, N>& placed, const F& f) {
  return f(detent::detail::HullPoints(placed).hull());
}

/// The cast of a box at a shape of a scene.
template <class Box, class Target, int N>
std::optional<CastHit<S, N>> cast_box(const Box& box, const Direction<S, N>& direction,
                                      S max_distance, const Target& target) {
  if constexpr (std::is_same_v<Box, Aabb<S, N>> && std::is_same_v<Target, Aabb<S, N>>) {
    return detent::cast(box, direction, max_distance, target);  // see Casts<N>::cast
  } else {
    return as_points(box, [&](const auto& moving) {
      return as_points(target, [&](const auto& other) {
        return cast_at(moving, direction, max_distance, other);
      });
    });
  }
}
}  // namespace detent::c

namespace detent::detail {

using c::S;

#define DETENT_C_BOX_CAST(N, Box, Shape)                                                      \
  template <>                                                                                 \
  inline std::optional<detent::CastHit<S, N>>                                                 \
  call_separate<job::CastHit, std::optional<detent::CastHit<S, N>>>(                          \
      const Cast<Box<S, N>>& moving, const Shape<S, N>& shape) noexcept {                     \
    return c::cast_box(moving.shape, moving.direction, moving.max_distance, shape);           \
  }                                                                                           \
  template <>                                                                                 \
  inline std::optional<S> call_separate<job::CastDistance, std::optional<S>>(                 \
      const Cast<Box<S, N>>& moving, const Shape<S, N>& shape) noexcept {                     \
    const auto hit = c::cast_box(moving.shape, moving.direction, moving.max_distance, shape); \
    return hit ? std::optional(hit->distance) : std::nullopt;                                 \
  }
#define DETENT_C_BOX_CASTS(N, KIND, Shape, name) \
  DETENT_C_BOX_CAST(N, Aabb, Shape)              \
  DETENT_C_BOX_CAST(N, Obb, Shape)
DETENT_C_SCENE_SHAPES(DETENT_C_BOX_CASTS, 2)
DETENT_C_SCENE_SHAPES(DETENT_C_BOX_CASTS, 3)
DETENT_C_BOX_CASTS(2, HULL, PlacedHull, placed)
DETENT_C_BOX_CASTS(3, HULL, PlacedHull, placed)

}  // namespace detent::detail
