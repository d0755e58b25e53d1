// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "detent/scene/static_tree/build.hpp"
#include "detent/shape/triangle.hpp"

namespace detent {

/// A triangle of a mesh and what its owner calls it: answers name this index, and order by it.
template <Scalar S>
struct MeshTriangle {
  Triangle<S, 3> triangle;
  std::uint32_t index = 0;

  [[nodiscard]] friend constexpr bool operator==(const MeshTriangle&,
                                                 const MeshTriangle&) noexcept = default;
};

/// The canonical bytes of a digest: the fields in order.
template <class D, Scalar S>
constexpr void append(D& digest, const MeshTriangle<S>& part) noexcept {
  digest.add(part.triangle, part.index);
}

template <Scalar S>
[[nodiscard]] constexpr Aabb<S, 3> bounding_box(const MeshTriangle<S>& part) noexcept {
  return bounding_box(part.triangle);
}

template <Scalar S>
using MeshNode = StaticNode<S, 3>;

/// The points of any of many triangles, a surface: a view of triangles and of a tree over them,
/// both in storage that the caller keeps. `build_mesh` makes one; `OwnedMesh` keeps its storage.
///
/// Its answers are those of a loop over all its triangles, each decided exactly, so nothing slips
/// between two that share an edge; how the tree came out never shows.
template <Scalar S>
struct Mesh {
  StaticTree<S, 3> tree;
  std::span<const MeshTriangle<S>> triangles;
};

/// The mesh of `triangles`, which it sorts, with its tree in `nodes`; nothing, and nothing touched,
/// where there are fewer than tree_capacity(triangles.size()) nodes.
template <Scalar S>
[[nodiscard]] constexpr std::optional<Mesh<S>> build_mesh(std::span<MeshTriangle<S>> triangles,
                                                          std::span<MeshNode<S>> nodes) noexcept {
  const auto tree = build_tree<S, 3, MeshTriangle<S>>(triangles, nodes);
  if (!tree) return std::nullopt;
  return Mesh<S>{*tree, triangles};
}

/// Three vertices of a list, by their places in it.
using VertexIndices = std::array<std::uint32_t, 3>;

/// Writes the triangles of an indexed mesh to `out`, each with its place in `faces` as its index;
/// false, and `out` is as it was, where it is of another size than `faces` or a vertex is missing.
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

}  // namespace detent
