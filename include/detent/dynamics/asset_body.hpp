// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "detent/scene/asset_instance.hpp"
#include "detent/scene/assets.hpp"
#include "detent/scene/bytes.hpp"

namespace detent::detail {

/// Reads a body's reference to an asset. Bodies hold the asset in their own frame, so translation
/// and rotation are those of the identity.
template <AssetInstance Body, class Assets>
[[nodiscard]] constexpr Restored read_asset(Reader& in, Body& body, const Assets& assets) noexcept {
  std::uint32_t id = 0;
  std::uint64_t digest = 0;
  in.get(id, digest, body.translation);
  if constexpr (requires { body.rotation; }) in.get(body.rotation);
  if (in.has_failed() || !(body == Body())) return Restored::corrupted;
  return assets.find(id, digest, body.asset);
}

}  // namespace detent::detail
