// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>

#include "detent/scene/asset_key.hpp"
#include "detent/scene/assets.hpp"
#include "detent/scene/bytes.hpp"

// Bodies that refer to an asset: hulls, compounds, meshes and height fields.

namespace detent {

namespace detail {

/// The names of an asset and of its digest in differences.
struct AssetNames {
  std::string_view id, digest;
};
template <class Body>
inline constexpr AssetNames asset_names{};

template <class Body>
concept AssetBody = HasAsset<Body> && !asset_names<Body>.id.empty();

/// Reads a body's reference to an asset. Bodies hold the asset in their own frame, so translation
/// and rotation are those of the identity.
template <AssetBody Body, class Assets>
[[nodiscard]] constexpr Restored read_asset(Reader& in, Body& body, const Assets& assets) noexcept {
  std::uint32_t id = 0;
  std::uint64_t digest = 0;
  in.get(id, digest, body.translation);
  if constexpr (requires { body.rotation; }) in.get(body.rotation);
  if (in.has_failed() || !(body == Body())) return Restored::corrupted;
  return assets.find(id, digest, body.asset);
}

}  // namespace detail

/// Appends to a digest: id and digest of the asset (zeros for none), translation and rotation.
template <class D, detail::AssetBody Body>
constexpr void append(D& digest, const Body& body) noexcept {
  const detail::AssetKey key(body.asset);
  digest.add(key.id, key.digest, body.translation);
  if constexpr (requires { body.rotation; }) digest.add(body.rotation);
}

/// The fields, named for differences: see scene/fields.hpp.
template <detail::AssetBody Body, class F>
constexpr void for_each_field(const Body& body, const F& f) {
  const detail::AssetKey key(body.asset);
  f(detail::asset_names<Body>.id, key.id);
  f(detail::asset_names<Body>.digest, key.digest);
  f("translation", body.translation);
  if constexpr (requires { body.rotation; }) for_each_field(body.rotation, f);
}

}  // namespace detent
