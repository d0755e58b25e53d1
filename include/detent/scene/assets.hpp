// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <tuple>

#include "detent/scene/header.hpp"

namespace detent {

/// A list of assets that snapshots refer to by id and digest: `MeshAsset`s, `HullAsset`s or
/// `FieldAsset`s.
template <class List>
concept AssetList = requires(const List& list) {
  std::span(list).front().id();
  std::span(list).front().digest();
};

namespace detail {

/// The lists in which a snapshot's references are looked up.
template <AssetList... Lists>
class AssetLists {
 public:
  explicit constexpr AssetLists(const Lists&... lists) noexcept : lists_(lists...) {}

  /// Finds the asset with this id and digest, or returns why there is none. Zeros stand for no
  /// asset.
  template <class Asset>
  [[nodiscard]] constexpr Restored find(std::uint32_t id, std::uint64_t digest,
                                        const Asset*& found) const noexcept {
    if (id == 0 && digest == 0) return Restored::yes;
    auto result = Restored::unknown_asset;
    std::apply([&](const auto&... list) { (look(list, id, digest, found, result), ...); }, lists_);
    return result;
  }

 private:
  template <class List, class Asset>
  static constexpr void look(const List& list, std::uint32_t id, std::uint64_t digest,
                             const Asset*& found, Restored& result) noexcept {
    if constexpr (requires { std::span<const Asset>(list); }) {
      for (const auto& asset : std::span<const Asset>(list)) {
        if (asset.id() != id || result == Restored::yes) continue;
        result = asset.digest() == digest ? Restored::yes : Restored::other_asset;
        if (result == Restored::yes) found = &asset;
      }
    }
  }

  std::tuple<const Lists&...> lists_;
};

/// A shape that refers to an asset, and has a transform or a translation.
template <class Shape>
concept HasAsset = requires(const Shape& shape) {
  shape.asset->id();
  shape.asset->digest();
};

/// Reads a shape whose asset has the id and the digest of one of `assets`.
template <HasAsset Shape, class Assets>
[[nodiscard]] constexpr Restored read_shape(Reader& in, Shape& shape,
                                            const Assets& assets) noexcept {
  std::uint32_t id = 0;
  std::uint64_t digest = 0;
  if constexpr (requires { shape.transform; }) {
    in.get(id, digest, shape.transform);
  } else {
    in.get(id, digest, shape.translation);
  }
  return assets.find(id, digest, shape.asset);
}

}  // namespace detail

}  // namespace detent
