// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "detent/scene/asset_instance.hpp"
#include "detent/scene/mesh/asset.hpp"
#include "detent/scene/mesh/placed_surface.hpp"
#include "detent/scene/shape_tag.hpp"

namespace detent {

/// A transformed mesh: a surface of the triangles `placed(transform, triangle)`, each coordinate
/// rounded once and clamped to the range of the scalar. If the transform only translates, and
/// everything stays in range, the triangles of the mesh are translated exactly.
///
/// The caller owns the asset, which must outlive it; without one there are no triangles.
template <Scalar S>
struct PlacedMesh {
  const MeshAsset<S>* asset = nullptr;
  Transform<S, 3> transform{};

  [[nodiscard]] friend constexpr bool operator==(const PlacedMesh&,
                                                 const PlacedMesh&) noexcept = default;
};

template <Scalar S>
PlacedMesh(const MeshAsset<S>*) -> PlacedMesh<S>;
template <Scalar S>
PlacedMesh(const MeshAsset<S>*, Transform<S, 3>) -> PlacedMesh<S>;

template <>
inline constexpr bool is_surface<PlacedMesh> = true;
template <>
inline constexpr bool is_placed_surface<PlacedMesh> = true;

template <Scalar S>
inline constexpr detail::AssetNames detail::asset_names<PlacedMesh<S>>{"mesh",
                                                                       "digest of its triangles"};

/// The mesh moved by a vector: the translation is rounded to nearest and clamped.
template <Scalar S>
[[nodiscard]] constexpr PlacedMesh<S> translated(const PlacedMesh<S>& mesh,
                                                 const Vec<S, 3>& by) noexcept {
  auto result = mesh;
  result.transform.translation = nearest_to<S>(mesh.transform.translation + by);
  return result;
}

/// The mesh moved from a local frame to the world: the transforms are composed and rounded.
template <Scalar S>
[[nodiscard]] constexpr PlacedMesh<S> placed(const Transform<S, 3>& transform,
                                             const PlacedMesh<S>& mesh) noexcept {
  return {mesh.asset, compose(transform, mesh.transform)};
}

namespace detail {

template <Scalar S>
inline constexpr std::uint8_t shape_tag<PlacedMesh<S>> = 7;

template <Scalar S>
struct AssetSurface<PlacedMesh<S>> {
  static constexpr const Mesh<S>& of(const PlacedMesh<S>& mesh) noexcept {
    return mesh.asset->mesh();
  }
  static constexpr const Vec<S, 3>& translation(const PlacedMesh<S>& mesh) noexcept {
    return mesh.transform.translation;
  }
  static constexpr bool only_moves(const PlacedMesh<S>& mesh) noexcept {
    return detail::only_moves(mesh.transform);
  }
  template <class Shape>
  static constexpr Shape put(const PlacedMesh<S>& mesh, const Shape& shape) noexcept {
    return detail::put(mesh.transform, shape);
  }
};

}  // namespace detail

}  // namespace detent
