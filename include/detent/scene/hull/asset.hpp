// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "detent/number/digest.hpp"
#include "detent/shape/hull.hpp"

namespace detent {

/// A convex hull that objects of scenes share, under an id of the caller's choice: it is what
/// snapshots say instead of points, with the digest that tells whether they are the same.
/// `hull_asset` makes one.
///
/// The points stay with the caller, and as they are: the digest is taken once.
template <Scalar S, int N>
class HullAsset {
 public:
  /// How many points it has at most: queries hold all of them, in their place, on the stack.
  static constexpr std::size_t capacity = 64;

  constexpr HullAsset() noexcept : HullAsset(0, ConvexHull<S, N>()) {}

  [[nodiscard]] constexpr const ConvexHull<S, N>& hull() const noexcept { return hull_; }
  [[nodiscard]] constexpr std::uint32_t id() const noexcept { return id_; }
  [[nodiscard]] constexpr std::uint64_t digest() const noexcept { return digest_; }

 private:
  constexpr HullAsset(std::uint32_t id, const ConvexHull<S, N>& view) noexcept
      : hull_(view), digest_(detent::digest(view)), id_(id) {}

  template <Scalar T, int M>
  friend constexpr std::optional<HullAsset<T, M>> hull_asset(std::uint32_t id,
                                                             const ConvexHull<T, M>& hull) noexcept;

  ConvexHull<S, N> hull_;
  std::uint64_t digest_;
  std::uint32_t id_;
};

/// The asset of this id and hull, or nothing where the hull has more than
/// `HullAsset<S, N>::capacity` points.
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<HullAsset<S, N>> hull_asset(
    std::uint32_t id, const ConvexHull<S, N>& hull) noexcept {
  if (hull.points.size() > HullAsset<S, N>::capacity) return std::nullopt;
  return HullAsset<S, N>(id, hull);
}

}  // namespace detent
