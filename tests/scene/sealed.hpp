// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "detent/scene/snapshot.hpp"

namespace detent {

/// The bytes with a valid checksum in the last word, so that only the rest matters.
inline std::vector<std::byte> sealed(std::vector<std::byte> bytes) {
  Digest digest;
  digest.add_bytes(std::span(bytes).first(bytes.size() - 8));
  detail::store_word(bytes.data() + bytes.size() - 8, digest.value());
  return bytes;
}

}  // namespace detent
