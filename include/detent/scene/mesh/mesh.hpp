// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "detent/cull/static_tree/along.hpp"
#include "detent/cull/static_tree/around.hpp"
#include "detent/cull/static_tree/build.hpp"
#include "detent/cull/static_tree/parts.hpp"
#include "detent/cull/static_tree/within.hpp"
#include "detent/query/distance/aabb.hpp"
#include "detent/scene/mesh/may_cross.hpp"
#include "detent/scene/mesh/surface.hpp"

namespace detent {

template <Scalar S>
using MeshNode = StaticNode<S, 3>;

/// A surface of triangles: a view of triangles and of a tree over them, both in the caller's
/// storage. `build_mesh` makes one; `OwnedMesh` owns its storage.
///
/// Results are those of a loop over all triangles, each decided exactly, so nothing slips between
/// two that share an edge. The shape of the tree never affects them. Queries only read: any number
/// of threads may share a mesh (tests/scene/threads.cpp).
template <Scalar S>
struct Mesh {
  StaticTree<S, 3> tree;
  std::span<const MeshTriangle<S>> triangles;
};

template <>
inline constexpr bool is_surface<Mesh> = true;

/// The mesh of `triangles`, which it reorders, with its tree in `nodes`. Returns nothing, and
/// changes nothing, if there are fewer than tree_capacity(triangles.size()) nodes.
template <Scalar S>
[[nodiscard]] constexpr std::optional<Mesh<S>> build_mesh(std::span<MeshTriangle<S>> triangles,
                                                          std::span<MeshNode<S>> nodes) noexcept {
  const auto tree = build_tree<S, 3, MeshTriangle<S>>(triangles, nodes);
  if (!tree) return std::nullopt;
  return Mesh<S>{*tree, triangles};
}

/// Three vertices, by their indices in a list.
using VertexIndices = std::array<std::uint32_t, 3>;

/// Writes the triangles of an indexed mesh to `out`, each with its index in `faces`. Returns false,
/// and leaves `out` unchanged, if its size is not that of `faces` or a vertex is missing.
template <Scalar S>
[[nodiscard]] constexpr bool assemble_triangles(std::span<const Vec<S, 3>> vertices,
                                                std::span<const VertexIndices> faces,
                                                std::span<MeshTriangle<S>> out) noexcept {
  if (out.size() != faces.size()) return false;
  for (const auto& face : faces) {
    for (const auto vertex : face) {
      if (vertex >= vertices.size()) return false;
    }
  }
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const auto [a, b, c] = faces[i];
    out[i] = {{vertices[a], vertices[b], vertices[c]}, static_cast<std::uint32_t>(i)};
  }
  return true;
}

/// The smallest box around all triangles of a mesh, empty for none.
template <Scalar S>
[[nodiscard]] constexpr Aabb<S, 3> bounding_box(const Mesh<S>& mesh) noexcept {
  return mesh.tree.bounds;
}

/// The traversals of a mesh: those of its tree.
template <Scalar S, class Visit>
constexpr Walk visit_along(const Mesh<S>& mesh, const Ray<S, 3>& ray, const Visit& visit) noexcept {
  return visit_along(mesh.tree, mesh.triangles, ray, visit);
}
template <Scalar S, class Visit>
constexpr Walk visit_within(const Mesh<S>& mesh, const Aabb<S, 3>& box,
                            const Visit& visit) noexcept {
  return visit_within(mesh.tree, mesh.triangles, box, visit);
}
template <Scalar S, class Visit>
constexpr Walk visit_crossing(const Mesh<S>& mesh, const Segment<S, 3>& segment,
                              const Visit& visit) noexcept {
  return visit_crossing(
      mesh.tree, mesh.triangles, bounding_box(segment),
      [&](const Aabb<S, 3>& box) { return detail::may_cross(segment, box); }, visit);
}
template <Scalar S, class Visit>
constexpr Walk visit_around(const Mesh<S>& mesh, const Vec<S, 3>& point,
                            const Visit& visit) noexcept {
  return visit_around(
      mesh.tree, mesh.triangles, [&](const Aabb<S, 3>& box) { return distance(box, point); },
      visit);
}

/// The parts of a mesh: those of its tree, see mesh/parts.hpp.
template <Scalar S>
[[nodiscard]] constexpr detail::StaticPart whole_of(const Mesh<S>&) noexcept {
  return detail::whole_tree;
}
template <Scalar S, class Visit>
constexpr Walk visit_children(const Mesh<S>& mesh, const detail::StaticPart& part,
                              const Visit& visit) noexcept {
  return visit_children(mesh.tree, part, visit);
}
template <Scalar S, class Visit>
constexpr Walk at_leaf(const Mesh<S>& mesh, const detail::StaticPart& leaf,
                       const Visit& visit) noexcept {
  return visit(mesh.triangles.subspan(leaf.first, leaf.count));
}

}  // namespace detent
