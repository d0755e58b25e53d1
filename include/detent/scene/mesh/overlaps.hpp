// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

#include "detent/cull/keep_first.hpp"
#include "detent/query/intersects/triangle.hpp"
#include "detent/query/overlaps/aabb_plane.hpp"
#include "detent/query/overlaps/aabb_triangle.hpp"
#include "detent/query/overlaps/obb_triangle.hpp"
#include "detent/query/overlaps/plane_triangle.hpp"
#include "detent/query/overlaps/sphere_triangle.hpp"
#include "detent/query/overlaps/triangle_capsule.hpp"
#include "detent/query/overlaps/triangle_hull.hpp"
#include "detent/query/overlaps/triangle_triangle.hpp"
#include "detent/scene/mesh/parts.hpp"

namespace detent {

/// A shape to test against a surface: one that has a bounding box, and `overlaps` with triangles.
template <class Shape, class S>
concept MeetsTriangles = requires(const Shape& shape, const Triangle<S, 3>& triangle) {
  bounding_box(shape);
  { overlaps(triangle, shape) } -> std::same_as<bool>;
}
&&!is_compound<Shape> && !is_surface_type<Shape>;

/// Whether `shape` (sphere, AABB, OBB, triangle, capsule, convex hull) touches any triangle of
/// `surface`.
///
/// domain: every input; an empty shape overlaps nothing
/// exact:  yes or no exact                               (tests/scene/mesh_overlaps.test.cpp)
template <template <class> class Surface, Scalar S, MeetsTriangles<S> Shape>
requires is_surface<Surface>
[[nodiscard]] constexpr bool overlaps(const Surface<S>& surface, const Shape& shape) noexcept {
  return detail::any_triangle_within(surface, bounding_box(shape),
                                     [&](const auto& part) { return overlaps(part, shape); });
}
template <template <class> class Surface, Scalar S, MeetsTriangles<S> Shape>
requires is_surface<Surface>
[[nodiscard]] constexpr bool overlaps(const Shape& shape, const Surface<S>& surface) noexcept {
  return overlaps(surface, shape);
}

/// The number of triangles of `surface` that the shape touches. Writes the least of their indices,
/// as many as `out` holds, sorted.
///
/// exact:  as for `overlaps`                             (tests/scene/mesh_overlaps.test.cpp)
template <template <class> class Surface, Scalar S, MeetsTriangles<S> Shape>
requires is_surface<Surface>
[[nodiscard]] constexpr std::size_t overlaps_all(const Surface<S>& surface, const Shape& shape,
                                                 std::span<std::uint32_t> out) noexcept {
  std::size_t count = 0;
  visit_within(surface, bounding_box(shape), [&](std::span<const MeshTriangle<S>> parts) {
    for (const auto& part : parts) {
      if (overlaps(part.triangle, shape)) detail::keep_first(out, count++, part.index);
    }
    return Walk::go_on;
  });
  detail::sort_kept(out, count);
  return count;
}

/// Whether any triangle of `surface` touches `plane`, with the normal exactly as stored.
///
/// exact:  yes or no exact                                  (tests/scene/mesh_pairs.test.cpp)
template <template <class> class Surface, Scalar S>
requires is_surface<Surface>
[[nodiscard]] constexpr bool overlaps(const Surface<S>& surface,
                                      const Plane<S, 3>& plane) noexcept {
  const auto walk = detail::visit_parts_where(
      surface, [&](const Aabb<S, 3>& box) { return overlaps(box, plane); },
      [&](std::span<const MeshTriangle<S>> parts) {
        return stop_if(
            detail::any_triangle(parts, [&](const auto& part) { return overlaps(part, plane); }));
      });
  return walk == Walk::stop;
}
template <template <class> class Surface, Scalar S>
requires is_surface<Surface>
[[nodiscard]] constexpr bool overlaps(const Plane<S, 3>& plane,
                                      const Surface<S>& surface) noexcept {
  return overlaps(surface, plane);
}

/// Whether `segment` touches any triangle of `surface`.
///
/// exact:  yes or no exact                               (tests/scene/mesh_overlaps.test.cpp)
template <template <class> class Surface, Scalar S>
requires is_surface<Surface>
[[nodiscard]] constexpr bool intersects(const Segment<S, 3>& segment,
                                        const Surface<S>& surface) noexcept {
  const auto walk = visit_crossing(surface, segment, [&](std::span<const MeshTriangle<S>> parts) {
    return stop_if(
        detail::any_triangle(parts, [&](const auto& part) { return intersects(segment, part); }));
  });
  return walk == Walk::stop;
}

}  // namespace detent
