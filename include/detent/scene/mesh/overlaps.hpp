// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

#include "detent/query/intersects/triangle.hpp"
#include "detent/query/overlaps/aabb_triangle.hpp"
#include "detent/query/overlaps/obb_triangle.hpp"
#include "detent/query/overlaps/sphere_triangle.hpp"
#include "detent/query/overlaps/triangle_capsule.hpp"
#include "detent/query/overlaps/triangle_hull.hpp"
#include "detent/query/overlaps/triangle_triangle.hpp"
#include "detent/scene/mesh/mesh.hpp"
#include "detent/scene/static_tree/keep_first.hpp"
#include "detent/scene/static_tree/within.hpp"

namespace detent {

/// A shape that a mesh can be asked about: one that has a box and overlaps triangles.
template <class Shape, class S>
concept MeetsMesh = requires(const Shape& shape, const Triangle<S, 3>& triangle) {
  bounding_box(shape);
  { overlaps(triangle, shape) } -> std::same_as<bool>;
}
&&!is_compound<Shape>;

/// Whether `shape` (sphere, AABB, OBB, triangle, capsule, convex hull) touches any triangle of
/// `mesh`.
///
/// domain: every input; an empty shape overlaps nothing
/// exact:  yes or no exact                               (tests/scene/mesh_overlaps.test.cpp)
template <Scalar S, MeetsMesh<S> Shape>
[[nodiscard]] constexpr bool overlaps(const Mesh<S>& mesh, const Shape& shape) noexcept {
  return visit_within(mesh.tree, mesh.triangles, bounding_box(shape), [&](auto leaf) {
    for (const auto& part : leaf) {
      if (overlaps(part.triangle, shape)) return true;
    }
    return false;
  });
}
template <Scalar S, MeetsMesh<S> Shape>
[[nodiscard]] constexpr bool overlaps(const Shape& shape, const Mesh<S>& mesh) noexcept {
  return overlaps(mesh, shape);
}

/// Whether two meshes touch: the triangles of the first are asked one by one, so name the smaller
/// one first.
template <Scalar S>
[[nodiscard]] constexpr bool overlaps(const Mesh<S>& a, const Mesh<S>& b) noexcept {
  return std::any_of(a.triangles.begin(), a.triangles.end(),
                     [&](const auto& part) { return overlaps(b, part.triangle); });
}

/// How many triangles of `mesh` the shape touches; writes the least of their indices, as many as
/// `out` holds, sorted.
///
/// exact:  as for `overlaps`                             (tests/scene/mesh_overlaps.test.cpp)
template <Scalar S, MeetsMesh<S> Shape>
[[nodiscard]] constexpr std::size_t overlaps_all(const Mesh<S>& mesh, const Shape& shape,
                                                 std::span<std::uint32_t> out) noexcept {
  std::size_t count = 0;
  visit_within(mesh.tree, mesh.triangles, bounding_box(shape), [&](auto leaf) {
    for (const auto& part : leaf) {
      if (overlaps(part.triangle, shape)) detail::keep_first(out, count++, part.index);
    }
    return false;
  });
  std::sort(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(std::min(count, out.size())));
  return count;
}

/// Whether `segment` touches any triangle of `mesh`.
///
/// exact:  yes or no exact                               (tests/scene/mesh_overlaps.test.cpp)
template <Scalar S>
[[nodiscard]] constexpr bool intersects(const Segment<S, 3>& segment,
                                        const Mesh<S>& mesh) noexcept {
  return visit_within(mesh.tree, mesh.triangles, bounding_box(segment), [&](auto leaf) {
    for (const auto& part : leaf) {
      if (intersects(segment, part.triangle)) return true;
    }
    return false;
  });
}

}  // namespace detent
