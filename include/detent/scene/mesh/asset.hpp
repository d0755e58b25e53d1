// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "detent/number/digest.hpp"
#include "detent/scene/mesh/mesh.hpp"

namespace detent {

/// Appends to a digest: the number of triangles and the sum of their digests, so
/// neither the tree nor the order of the triangles matters.
template <class D, Scalar S>
constexpr void append(D& out, const Mesh<S>& mesh) noexcept {
  std::uint64_t sum = 0;
  for (const auto& triangle : mesh.triangles) sum += digest(triangle);
  out.add(static_cast<std::uint64_t>(mesh.triangles.size()), sum);
}

/// A mesh that objects of scenes share, with an id chosen by the caller. Snapshots store the id and
/// the digest instead of the triangles; the digest shows whether the triangles are the same.
///
/// The triangles must not change: the digest is computed once.
template <Scalar S>
class MeshAsset {
 public:
  constexpr MeshAsset() noexcept : MeshAsset(0, Mesh<S>()) {}
  constexpr MeshAsset(std::uint32_t id, const Mesh<S>& view) noexcept
      : mesh_(view), digest_(detent::digest(view)), id_(id) {}

  [[nodiscard]] constexpr const Mesh<S>& mesh() const noexcept { return mesh_; }
  [[nodiscard]] constexpr std::uint32_t id() const noexcept { return id_; }
  [[nodiscard]] constexpr std::uint64_t digest() const noexcept { return digest_; }

 private:
  Mesh<S> mesh_;
  std::uint64_t digest_;
  std::uint32_t id_;
};

}  // namespace detent
