// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <type_traits>

#include "detent/cull/static_tree/along.hpp"
#include "detent/number/next_up.hpp"
#include "detent/query/cast/pair.hpp"
#include "detent/scene/mesh/beside.hpp"
#include "detent/scene/mesh/parts.hpp"
#include "detent/scene/mesh/raycast.hpp"
#include "detent/scene/separate.hpp"

namespace detent {

namespace detail {

/// A shape that can be cast against triangles.
template <class Shape, class S>
concept CastsAtTriangles =
    !is_surface_type<Shape> && requires(const Shape& shape, const Direction<S, 3>& direction,
                                        const S& distance, const Triangle<S, 3>& triangle) {
  cast_distance(shape, direction, distance, triangle);
};

/// A box around the path of a shape, if the path is on no axis longer than the shape.
template <class Shape, Scalar S>
[[nodiscard]] constexpr std::optional<Aabb<S, 3>> box_of_short_way(const Shape& shape,
                                                                   const Direction<S, 3>& direction,
                                                                   const S& max_distance) noexcept {
  auto box = bounding_box(shape);
  for (int i = 0; i < 3; ++i) {
    const auto by = direction[i] * max_distance;
    if (abs(by) > box.max[i] - box.min[i]) return std::nullopt;
    if (by < 0) box.min[i] = floor_to<S>(box.min[i] + by);
    if (by > 0) box.max[i] = ceil_to<S>(box.max[i] + by);
  }
  return box;
}

/// The first triangle of a surface that a moving shape touches.
template <class Shape, template <class> class Surface, Scalar S>
[[nodiscard]] constexpr std::optional<FoundOnSurface<S>> first_on_surface(
    const Cast<Shape>& moving, const Surface<S>& surface) noexcept {
  const auto& shape = moving.shape;
  const auto& direction = moving.direction;
  const S& max_distance = moving.max_distance;
  using Time = typename Ticks<S>::Time;
  std::optional<FoundOnSurface<S>> best;
  const auto box = quantized_box(shape);
  const auto bounds = bounding_box(surface);
  if (max_distance < 0 || box.is_empty() || is_empty(bounds)) return best;
  const StaticRay<S, 3> prepared(box, direction, max_distance, bounds);
  S limit = max_distance;
  Time last = prepared.time(limit);
  const auto reach = [&](const Aabb<S, 3>& part) { return prepared.meets(part, last); };
  // For round shapes the cast itself takes no longer.
  constexpr bool looks_first = !filter_pays<S> || !requires { shape.radius; };
  const auto test = [&](std::span<const MeshTriangle<S>> triangles) {
    for (const auto& part : triangles) {
      if (!reach(bounding_box(part))) continue;
      if (looks_first && stays_beside(shape, direction, limit, part.triangle)) continue;
      const auto distance = cast_distance(shape, direction, limit, part.triangle);
      if (!distance) continue;
      const MeshHit<S> hit{*distance, part.index};
      if (!best || hit < best->hit) best = FoundOnSurface<S>{hit, part.triangle};
      // Of hits that round down to the same distance, the least index wins.
      limit = (std::min)(max_distance, next_up(best->hit.distance));
      last = prepared.time(limit);
    }
    return Walk::go_on;
  };
  if (const auto around = box_of_short_way(shape, direction, max_distance)) {
    visit_within(surface, *around, test);
  } else {
    visit_parts<Time>(
        surface, reach, [&](const Time& enter) { return enter <= last; }, test);
  }
  return best;
}

template <template <class> class Surface, Scalar S>
requires is_surface<Surface>
struct CastAt<Surface<S>> {
  template <class Shape>
  [[nodiscard]] static constexpr std::optional<S> distance(const Cast<Shape>& moving,
                                                           const Surface<S>& surface) noexcept {
    const auto found = first_on_surface(moving, surface);
    if (!found) return std::nullopt;
    return found->hit.distance;
  }
};

template <template <class> class Surface, Scalar S, CastsAtTriangles<S> Shape>
requires is_surface<Surface>
[[nodiscard]] constexpr std::optional<S> cast_distance(const Shape& shape,
                                                       const Direction<S, 3>& direction,
                                                       const std::type_identity_t<S>& max_distance,
                                                       const Surface<S>& surface) noexcept {
  return CastAt<Surface<S>>::distance(Cast<Shape>{shape, direction, max_distance}, surface);
}

}  // namespace detail

/// The first triangle of `surface` that `shape` touches when it moves along `direction`, and the
/// distance, or nothing.
///
/// units:  lengths in world units
/// domain: every input; shapes and triangles as for `cast(shape, direction, distance, triangle)`
/// result: of triangles whose distances round down to the same number, the one with the least index
/// exact:  hit or miss exact; distance rounded down, error in [0, 1) ULP
///         (tests/scene/mesh_cast.test.cpp)
template <template <class> class Surface, Scalar S, detail::CastsAtTriangles<S> Shape>
requires is_surface<Surface>
[[nodiscard]] constexpr std::optional<MeshHit<S>> cast_nearest(
    const Shape& shape, const Direction<S, 3>& direction,
    const std::type_identity_t<S>& max_distance, const Surface<S>& surface) noexcept {
  const auto found = detail::first_on_surface(Cast<Shape>{shape, direction, max_distance}, surface);
  if (!found) return std::nullopt;
  return found->hit;
}

template <template <class> class Surface, Scalar S, detail::CastsAtTriangles<S> Shape>
requires is_surface<Surface>
[[nodiscard]] constexpr std::optional<MeshHit<S>> cast_nearest(const Cast<Shape>& moving,
                                                               const Surface<S>& surface) noexcept {
  return cast_nearest(moving.shape, moving.direction, moving.max_distance, surface);
}

/// Distance, point and normal where `shape` first touches `surface` when it moves along
/// `direction`, or nothing: those of the triangle of `cast_nearest`.
///
/// exact:  as `cast(shape, direction, distance, triangle)`   (tests/scene/mesh_cast.test.cpp)
template <template <class> class Surface, Scalar S, detail::CastsAtTriangles<S> Shape>
requires is_surface<Surface>
[[nodiscard]] constexpr std::optional<CastHit<S, 3>> cast(
    const Shape& shape, const Direction<S, 3>& direction,
    const std::type_identity_t<S>& max_distance, const Surface<S>& surface) noexcept {
  const auto found = detail::first_on_surface(Cast<Shape>{shape, direction, max_distance}, surface);
  if (!found) return std::nullopt;
  return cast(shape, direction, max_distance, found->triangle);
}

}  // namespace detent
