// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>

#include "detent/number/require_cxx20.hpp"
#include "detent/scene/fields.hpp"

// Shapes and bodies that refer to an asset: digests and differences have its id and digest instead.

namespace detent {

namespace detail {

/// The names of an asset and of its digest in differences.
struct AssetNames {
  std::string_view id, digest;
};
template <class Shape>
inline constexpr AssetNames asset_names{};

/// A shape or body with an `asset`, and a `transform`, or a `translation` and perhaps a `rotation`.
template <class Shape>
concept AssetInstance = !asset_names<Shape>.id.empty();

/// The id and the digest of an asset, zeros for none.
struct AssetKey {
  std::uint32_t id = 0;
  std::uint64_t digest = 0;

  template <class Asset>
  explicit constexpr AssetKey(const Asset* asset) noexcept {
    if (asset == nullptr) return;
    id = asset->id();
    digest = asset->digest();
  }
};

}  // namespace detail

/// Appends to a digest: id and digest of the asset (zeros for none), and the transform, or
/// translation and rotation.
template <class D, detail::AssetInstance Shape>
constexpr void append(D& digest, const Shape& shape) noexcept {
  const detail::AssetKey key(shape.asset);
  digest.add(key.id, key.digest);
  if constexpr (requires { shape.transform; }) {
    digest.add(shape.transform);
  } else {
    digest.add(shape.translation);
    if constexpr (requires { shape.rotation; }) digest.add(shape.rotation);
  }
}

/// The fields, named for differences: see fields.hpp.
template <detail::AssetInstance Shape, class F>
constexpr void for_each_field(const Shape& shape, const F& f) {
  const detail::AssetKey key(shape.asset);
  f(detail::asset_names<Shape>.id, key.id);
  f(detail::asset_names<Shape>.digest, key.digest);
  if constexpr (requires { shape.transform; }) {
    for_each_field(shape.transform, f);
  } else {
    f("translation", shape.translation);
    if constexpr (requires { shape.rotation; }) for_each_field(shape.rotation, f);
  }
}

}  // namespace detent
