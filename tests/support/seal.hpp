// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

#include "detent/number/digest.hpp"

namespace detent::test {

/// Recomputes the checksum of a snapshot, its last 8 bytes, so that only the rest matters.
inline void seal(std::span<std::byte> bytes) {
  const auto rest = bytes.first(bytes.size() - 8);
  Digest digest;
  digest.add_bytes(rest);
  detail::store_word(bytes.data() + rest.size(), digest.value());
}

}  // namespace detent::test
