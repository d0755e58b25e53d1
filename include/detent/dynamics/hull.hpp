// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "detent/dynamics/asset_body.hpp"
#include "detent/dynamics/body.hpp"
#include "detent/dynamics/manifold/facets.hpp"
#include "detent/dynamics/mass.hpp"
#include "detent/scene/assets.hpp"
#include "detent/scene/hull/asset.hpp"
#include "detent/scene/shape_tag.hpp"

namespace detent {

/// A convex polygon or polyhedron that bodies share, with its faces and an id chosen by the caller;
/// `BodyHull` refers to it. `solid_hull` makes one. Snapshots store the id and the digest of the
/// points; the digest shows whether they are the same.
///
/// The caller owns the points and must not change them.
template <Scalar S, int N>
class SolidHull {
 public:
  /// The most points of a hull.
  static constexpr std::size_t capacity = 32;

  constexpr SolidHull() noexcept : SolidHull(HullAsset<S, N>()) {}

  [[nodiscard]] constexpr const ConvexHull<S, N>& hull() const noexcept { return asset_.hull(); }
  [[nodiscard]] constexpr std::uint32_t id() const noexcept { return asset_.id(); }
  [[nodiscard]] constexpr std::uint64_t digest() const noexcept { return asset_.digest(); }
  /// The same hull for scenes.
  [[nodiscard]] constexpr const HullAsset<S, N>& asset() const noexcept { return asset_; }
  /// The center of mass, in the frame of the points.
  [[nodiscard]] constexpr const auto& center() const noexcept { return center_; }
  /// The faces, relative to the center of mass.
  [[nodiscard]] constexpr detail::Polytope<S, N> faces() const noexcept { return parts_.view(); }

  /// What `solid_hull` returns.
  [[nodiscard]] static constexpr std::optional<SolidHull> make(
      std::uint32_t id, const ConvexHull<S, N>& hull) noexcept {
    if (hull.points.size() > capacity) return std::nullopt;
    const auto properties = mass_properties(hull, S(1));
    if (!(properties.mass > 0)) return std::nullopt;
    SolidHull solid(*hull_asset(id, hull));
    solid.center_ = properties.center;
    solid.parts_ = detail::facets_of<capacity>(hull.points, properties.center);
    return solid;
  }

 private:
  static_assert(capacity <= HullAsset<S, N>::capacity);
  explicit constexpr SolidHull(const HullAsset<S, N>& asset) noexcept : asset_(asset) {}

  HullAsset<S, N> asset_;
  Vec<typename detail::MassFormats<S>::Center, N> center_{};
  detail::PolytopeParts<S, N, capacity> parts_{};
};

/// The solid of this hull, or nothing if it has more than `SolidHull<S, N>::capacity` points or no
/// volume at density 1.
///
/// units:  lengths in world units
/// domain: every hull; points inside it, or on its faces and edges, make no difference
/// exact:  which points are corners of which face; unit vectors rounded once to nearest
///                                                       (tests/dynamics/hull.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<SolidHull<S, N>> solid_hull(
    std::uint32_t id, const ConvexHull<S, N>& hull) noexcept {
  return SolidHull<S, N>::make(id, hull);
}

/// A convex body: the points of `asset`, rotated, then moved by `translation`. Worlds that hold such
/// bodies list it: `World<q16_16, 3, Sphere, BodyHull>`.
///
/// The body's position is its center of mass. The caller owns the asset, which must outlive the
/// world; a body without one has no mass and touches nothing.
template <Scalar S, int N>
struct BodyHull {
  const SolidHull<S, N>* asset = nullptr;
  Vec<S, N> translation{};
  Rotation<S, N> rotation{};

  [[nodiscard]] friend constexpr bool operator==(const BodyHull&,
                                                 const BodyHull&) noexcept = default;
};

template <Scalar S, int N>
BodyHull(const SolidHull<S, N>*, Vec<S, N> = {}, Rotation<S, N> = {}) -> BodyHull<S, N>;

template <Scalar S, int N>
inline constexpr detail::AssetNames detail::asset_names<BodyHull<S, N>>{"hull",
                                                                        "digest of its points"};

/// The mass of the hull about its center of mass.
///
/// domain: every density; mass 0 without an asset
/// exact:  as of a `ConvexHull`                              (tests/dynamics/mass.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr MassProperties<S, N> mass_properties(const BodyHull<S, N>& body,
                                                             S density) noexcept {
  return body.asset ? mass_properties(body.asset->hull(), density) : MassProperties<S, N>{};
}

namespace detail {

template <class T>
inline constexpr bool is_hull_body = false;
template <Scalar S, int N>
inline constexpr bool is_hull_body<BodyHull<S, N>> = true;

template <Scalar S, int N>
inline constexpr std::uint8_t shape_tag<BodyHull<S, N>> = 10;

/// The corners of a hull in the frame of its body.
template <Scalar S, int N>
[[nodiscard]] constexpr Polytope<S, N> faces_of(const BodyHull<S, N>& body) noexcept {
  return body.asset ? body.asset->faces() : Polytope<S, N>();
}

}  // namespace detail

}  // namespace detent
