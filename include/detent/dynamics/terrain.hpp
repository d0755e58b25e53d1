// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "detent/dynamics/asset_body.hpp"
#include "detent/dynamics/hull.hpp"
#include "detent/scene/height_field/asset.hpp"
#include "detent/scene/mesh/asset.hpp"

namespace detent {

/// A body that is a surface of triangles, in 3D: the mesh `asset`, rotated, then moved by
/// `translation`. Worlds that hold such bodies list it: `World<q16_16, 3, Sphere, BodyMesh>`.
///
/// It has no mass: it is fixed or kinematic, whatever its options are. Triangles are one-sided:
/// they touch bodies whose center is not behind them, where their corners are clockwise. Their
/// indices must be different and below `part_limit`; others touch nothing. The caller owns the
/// asset, which must outlive the world.
template <Scalar S, int N>
struct BodyMesh {
  static_assert(N == 3, "meshes are surfaces in 3D");
  static constexpr std::uint32_t part_limit = std::uint32_t{1} << 20;
  const MeshAsset<S>* asset = nullptr;
  Vec<S, N> translation{};
  Rotation<S, N> rotation{};

  [[nodiscard]] friend constexpr bool operator==(const BodyMesh&,
                                                 const BodyMesh&) noexcept = default;
};

template <Scalar S>
BodyMesh(const MeshAsset<S>*, Vec<S, 3> = {}, Rotation<S, 3> = {}) -> BodyMesh<S, 3>;

/// A body that is terrain, in 3D: the height field `asset`, moved by `translation`, with the same
/// limits as `BodyMesh`. Everything below its surface is solid: a body that reaches it from below
/// is pushed out above.
template <Scalar S, int N>
struct BodyHeightField {
  static_assert(N == 3, "height fields are surfaces in 3D");
  static constexpr std::uint32_t part_limit = BodyMesh<S, N>::part_limit;
  const FieldAsset<S>* asset = nullptr;
  Vec<S, N> translation{};

  [[nodiscard]] friend constexpr bool operator==(const BodyHeightField&,
                                                 const BodyHeightField&) noexcept = default;
};

template <Scalar S>
BodyHeightField(const FieldAsset<S>*, Vec<S, 3> = {}) -> BodyHeightField<S, 3>;

namespace detail {

template <class T>
inline constexpr bool is_surface_body = false;
template <Scalar S, int N>
inline constexpr bool is_surface_body<BodyMesh<S, N>> = true;
template <Scalar S, int N>
inline constexpr bool is_surface_body<BodyHeightField<S, N>> = true;

/// Whether a body may be pushed out of a surface when its center is behind it.
template <class T>
inline constexpr bool is_solid_below = false;
template <Scalar S, int N>
inline constexpr bool is_solid_below<BodyHeightField<S, N>> = true;

/// The surface of a body that has an asset.
template <Scalar S, int N>
[[nodiscard]] constexpr const Mesh<S>& surface_of(const BodyMesh<S, N>& body) noexcept {
  return body.asset->mesh();
}
template <Scalar S, int N>
[[nodiscard]] constexpr const HeightField<S>& surface_of(
    const BodyHeightField<S, N>& body) noexcept {
  return body.asset->field();
}

template <Scalar S, int N>
inline constexpr std::uint8_t shape_tag<BodyMesh<S, N>> = 11;
template <Scalar S, int N>
inline constexpr std::uint8_t shape_tag<BodyHeightField<S, N>> = 12;

}  // namespace detail

template <class Body>
requires detail::is_surface_body<Body>
inline constexpr detail::AssetNames detail::asset_names<Body>{"surface", "digest of its triangles"};

/// A surface has no mass.
template <Scalar S, int N>
[[nodiscard]] constexpr MassProperties<S, N> mass_properties(const BodyMesh<S, N>&, S) noexcept {
  return {};
}
template <Scalar S, int N>
[[nodiscard]] constexpr MassProperties<S, N> mass_properties(const BodyHeightField<S, N>&,
                                                             S) noexcept {
  return {};
}

}  // namespace detent
