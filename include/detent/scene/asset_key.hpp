// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "detent/number/require_cxx20.hpp"

namespace detent::detail {

/// The key of an asset in digests and differences: its id and digest, zeros for none.
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

}  // namespace detent::detail
