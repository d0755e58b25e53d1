// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "property.hpp"

namespace detent::fuzz {

/// Reads numbers from bytes, then zeros when they are used up.
class Source {
 public:
  explicit Source(Bytes bytes) : bytes_(bytes) {}

  std::uint8_t byte() {
    if (bytes_.empty()) return 0;
    const auto first = bytes_.front();
    bytes_ = bytes_.subspan(1);
    return first;
  }
  /// In [0, count), for a count of at most 256: one byte.
  std::size_t below(std::size_t count) { return byte() % count; }
  /// `count` bytes, the lowest first.
  std::uint64_t word(int count = 8) {
    std::uint64_t result = 0;
    for (int i = 0; i < count; ++i) result |= std::uint64_t{byte()} << (8 * i);
    return result;
  }
  /// In [-2^bits, 2^bits), for at most 63 bits.
  std::int64_t bits(int bits) {
    const auto pattern = word(bits / 8 + 1) << (63 - bits);
    return static_cast<std::int64_t>(pattern) >> (63 - bits);
  }
  /// -1, 0 or 1.
  int step() { return static_cast<int>(below(3)) - 1; }

  [[nodiscard]] Bytes rest() const { return bytes_; }

 private:
  Bytes bytes_;
};

}  // namespace detent::fuzz
