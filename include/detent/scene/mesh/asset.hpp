// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "detent/number/digest.hpp"
#include "detent/scene/mesh/mesh.hpp"

namespace detent {

/// The canonical bytes of a digest: how many triangles there are and the sum of their digests, so
/// neither the tree nor the order of the triangles in it counts.
template <class D, Scalar S>
constexpr void append(D& out, const Mesh<S>& mesh) noexcept {
  std::uint64_t sum = 0;
  for (const auto& triangle : mesh.triangles) sum += digest(triangle);
  out.add(static_cast<std::uint64_t>(mesh.triangles.size()), sum);
}

/// A mesh that objects of scenes share, under an id of the caller's choice: it is what snapshots
/// say instead of triangles, with the digest that tells whether they are the same.
///
/// The triangles must stay as they are: the digest is taken once.
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
