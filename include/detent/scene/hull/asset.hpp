// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "detent/math/transform.hpp"
#include "detent/number/digest.hpp"
#include "detent/shape/hull.hpp"

namespace detent {

/// A convex hull that objects of scenes share, with an id chosen by the caller. Snapshots store the
/// id and the digest instead of the points; the digest shows whether the points are the same.
/// `hull_asset` makes one.
///
/// The caller owns the points and must not change them: the digest is computed once.
template <Scalar S, int N>
class HullAsset {
 public:
  /// The most points of a hull: queries keep all of them, transformed, on the stack.
  static constexpr std::size_t capacity = 64;

  constexpr HullAsset() noexcept : HullAsset(0, ConvexHull<S, N>()) {}

  [[nodiscard]] constexpr const ConvexHull<S, N>& hull() const noexcept { return hull_; }
  [[nodiscard]] constexpr std::uint32_t id() const noexcept { return id_; }
  [[nodiscard]] constexpr std::uint64_t digest() const noexcept { return digest_; }

  /// What `hull_asset` returns.
  [[nodiscard]] static constexpr std::optional<HullAsset> make(
      std::uint32_t id, const ConvexHull<S, N>& hull) noexcept {
    if (hull.points.size() > capacity) return std::nullopt;
    return HullAsset(id, hull);
  }

 private:
  constexpr HullAsset(std::uint32_t id, const ConvexHull<S, N>& view) noexcept
      : hull_(view), digest_(detent::digest(view)), id_(id) {}

  ConvexHull<S, N> hull_;
  std::uint64_t digest_;
  std::uint32_t id_;
};

/// The asset of this id and hull, or nothing if the hull has more than `HullAsset<S, N>::capacity`
/// points.
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<HullAsset<S, N>> hull_asset(
    std::uint32_t id, const ConvexHull<S, N>& hull) noexcept {
  return HullAsset<S, N>::make(id, hull);
}

/// A transformed convex hull: the hull of its transformed points, each coordinate rounded once from
/// the exact one and clamped to the range of the scalar.
///
/// It has every query of a `ConvexHull`, exact for those points. Each query transforms the points
/// first, which costs little compared with the query itself.
///                                                       (tests/scene/asset_instances.test.cpp)
///
/// The caller owns the asset, which must outlive it; without one it is empty.
template <Scalar S, int N>
struct PlacedHull {
  const HullAsset<S, N>* asset = nullptr;
  Transform<S, N> transform{};

  [[nodiscard]] friend constexpr bool operator==(const PlacedHull&,
                                                 const PlacedHull&) noexcept = default;
};

template <Scalar S, int N>
PlacedHull(const HullAsset<S, N>*) -> PlacedHull<S, N>;
template <Scalar S, int N>
PlacedHull(const HullAsset<S, N>*, Transform<S, N>) -> PlacedHull<S, N>;

}  // namespace detent
