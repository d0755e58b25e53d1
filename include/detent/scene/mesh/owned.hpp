// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "detent/scene/mesh/mesh.hpp"

namespace detent {

/// A mesh that owns its triangles and its tree. Pass `view()` to queries.
///
/// Copies are independent of each other. No other mesh header needs a heap.
template <Scalar S>
class OwnedMesh {
 public:
  OwnedMesh() = default;

  /// The triangles of a list; the index of each is its position in the list.
  explicit OwnedMesh(std::span<const Triangle<S, 3>> triangles) {
    triangles_.reserve(triangles.size());
    for (const auto& triangle : triangles) {
      triangles_.push_back({triangle, static_cast<std::uint32_t>(triangles_.size())});
    }
    build();
  }

  /// The triangles of an indexed mesh, or nothing if a vertex is missing.
  [[nodiscard]] static std::optional<OwnedMesh> from_faces(std::span<const Vec<S, 3>> vertices,
                                                           std::span<const VertexIndices> faces) {
    OwnedMesh mesh;
    mesh.triangles_.resize(faces.size());
    if (!assemble_triangles<S>(vertices, faces, mesh.triangles_)) return std::nullopt;
    mesh.build();
    return mesh;
  }

  /// The mesh, valid as long as this object lives unchanged.
  [[nodiscard]] Mesh<S> view() const noexcept { return {{nodes_, bounds_}, triangles_}; }

 private:
  void build() {
    nodes_.resize(tree_capacity(triangles_.size()));
    if (const auto mesh = build_mesh<S>(triangles_, nodes_)) {
      bounds_ = mesh->tree.bounds;
      nodes_.resize(mesh->tree.nodes.size());
      nodes_.shrink_to_fit();
    }
  }

  std::vector<MeshTriangle<S>> triangles_;
  std::vector<MeshNode<S>> nodes_;
  Aabb<S, 3> bounds_ = detail::no_box<Aabb<S, 3>>;
};

}  // namespace detent
