// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <utility>

#include "detent/query/closest_points/pair.hpp"
#include "detent/scene/mesh/distance.hpp"

namespace detent {

namespace detail {

/// The triangle of `surface` nearest to `shape`, of equally near ones the one of the least index,
/// among those no farther than `least`; sets `least` to its distance. to_shape(triangle, least) is
/// the distance of a triangle, or nothing if it exceeds `least`.
template <class Surface, class Shape, Scalar S, class ToShape>
[[nodiscard]] constexpr std::optional<MeshTriangle<S>> nearest_part(
    const Surface& surface, const Shape& shape, S& least, const ToShape& to_shape) noexcept {
  std::optional<MeshTriangle<S>> best;
  const auto reach = culled_as(shape);
  visit_parts<S>(
      surface,
      [&](const Aabb<S, 3>& box) {
        const S to_box = distance(box, reach);
        return to_box <= least ? std::optional(to_box) : std::nullopt;
      },
      [&](const S& to_box) { return to_box <= least; },
      [&](std::span<const MeshTriangle<S>> triangles) {
        for (const auto& part : triangles) {
          const std::optional<S> to_part = to_shape(part.triangle, least);
          if (!to_part || (best && *to_part == least && part.index > best->index)) continue;
          best = part;
          least = *to_part;
        }
        return Walk::go_on;
      });
  return best;
}
template <class Surface, class Shape, Scalar S>
[[nodiscard]] constexpr auto nearest_part(const Surface& surface, const Shape& shape,
                                          S& least) noexcept {
  return nearest_part(surface, shape, least, [&](const Triangle<S, 3>& triangle, const S& limit) {
    const S to_triangle = distance(triangle, shape);
    return to_triangle <= limit ? std::optional(to_triangle) : std::nullopt;
  });
}

}  // namespace detail

/// The closest points of `shape` and the triangle of `surface` nearest to it. A shape inside a
/// closed mesh is as far from it as from its triangles.
///
/// units:  world units
/// domain: every input; the origin twice for an empty shape or a surface without triangles
/// result: of triangles with equal `distance`s, even if only by rounding or clamping, the one of
///         the least index
/// exact:  the triangle is the nearest within 1 ULP; each coordinate is rounded as by
///         `closest_points` of the triangle
///         (tests/scene/mesh_closest_points.test.cpp)
template <template <class> class Surface, Scalar S, detail::HasDistance<S> Shape>
requires is_surface<Surface>
[[nodiscard]] constexpr std::pair<Vec<S, 3>, Vec<S, 3>> closest_points(
    const Surface<S>& surface, const Shape& shape) noexcept {
  S least = largest<S>;
  const auto nearest = detail::nearest_part(surface, shape, least);
  if (!nearest) return {};
  return closest_points(nearest->triangle, shape);
}
template <template <class> class Surface, Scalar S, detail::HasDistance<S> Shape>
requires is_surface<Surface>
[[nodiscard]] constexpr std::pair<Vec<S, 3>, Vec<S, 3>> closest_points(
    const Shape& shape, const Surface<S>& surface) noexcept {
  S least = largest<S>;
  const auto nearest = detail::nearest_part(surface, shape, least);
  if (!nearest) return {};
  return closest_points(shape, nearest->triangle);
}

/// The closest points of the nearest triangles of two surfaces.
///
/// result: of pairs with equal `distance`s, the one with the least index in `a`, then in `b`
/// exact:  as above                                (tests/scene/mesh_closest_points.test.cpp)
template <template <class> class A, template <class> class B, Scalar S>
requires(is_surface<A>&& is_surface<B>)
    [[nodiscard]] constexpr std::pair<Vec<S, 3>, Vec<S, 3>> closest_points(const A<S>& a,
                                                                           const B<S>& b) noexcept {
  S least = largest<S>;
  const auto nearest =
      detail::nearest_part(a, b, least, [&](const Triangle<S, 3>& triangle, const S& limit) {
        S to_triangle = limit;
        const bool is_within = detail::nearest_part(b, triangle, to_triangle).has_value();
        return is_within ? std::optional(to_triangle) : std::nullopt;
      });
  if (!nearest) return {};
  const auto other = detail::nearest_part(b, nearest->triangle, least);
  if (!other) return {};
  return closest_points(nearest->triangle, other->triangle);
}

}  // namespace detent
