// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <type_traits>

#include "detent/scene/header.hpp"
#include "detent/scene/mesh/closest_point.hpp"
#include "detent/scene/mesh/contains.hpp"
#include "detent/scene/mesh/overlaps.hpp"
#include "detent/scene/mesh/pairs.hpp"
#include "detent/scene/mesh/placed.hpp"
#include "detent/scene/mesh/raycast.hpp"

namespace detent {

/// What a scene lists to hold meshes, in 3D: `Scene<q16_16, 3, Sphere, MeshInstance>`, whose
/// objects are each a `PlacedMesh<q16_16>`. Snapshots refer to meshes by id and digest.
template <Scalar S, int N>
using MeshInstance = std::enable_if_t<N == 3, PlacedMesh<S>>;

namespace detail {

/// Reads a mesh that is one of `meshes`: of one id, that with the same digest.
template <Scalar S, class Meshes>
[[nodiscard]] constexpr Restored read_shape(Reader& in, PlacedMesh<S>& shape,
                                            const Meshes& meshes) noexcept {
  std::uint32_t id = 0;
  std::uint64_t digest = 0;
  in.get(id, digest, shape.transform);
  if (id == 0 && digest == 0) return Restored::yes;
  auto result = Restored::unknown_mesh;
  if constexpr (!std::is_same_v<Meshes, NoMeshes>) {
    for (const auto& asset : std::span<const MeshAsset<S>>(meshes)) {
      if (asset.id() != id) continue;
      if (asset.digest() == digest) {
        shape.asset = &asset;
        return Restored::yes;
      }
      result = Restored::other_mesh;
    }
  }
  return result;
}

}  // namespace detail

}  // namespace detent
