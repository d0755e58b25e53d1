// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "detent/number/require_cxx20.hpp"

// Numbers of a few bits in a packet: lowest bit first, in bytes of increasing address, so the bytes
// are the same for both byte orders.

namespace detent::detail {

/// Appends bits as far as there is room, and counts all of them.
class BitWriter {
 public:
  /// Continues after `count` bits that are already in `room`.
  explicit constexpr BitWriter(std::span<std::byte> room, std::size_t count = 0) noexcept
      : room_(room), size_(count) {}

  /// Appends the low `count` bits of `value`; `count` <= 64.
  constexpr void add(std::uint64_t value, int count) noexcept {
    for (int i = 0; i < count; ++i, ++size_) {
      const auto at = size_ / 8;
      if (at >= room_.size()) continue;
      if (size_ % 8 == 0) room_[at] = std::byte{0};
      if (((value >> i) & 1u) != 0) room_[at] |= std::byte{1} << (size_ % 8);
    }
  }
  constexpr void add_flag(bool value) noexcept { add(value ? 1 : 0, 1); }
  /// Appends a number that is usually small: three bits at a time, each with a flag for more.
  constexpr void add_short(std::uint32_t value) noexcept {
    for (; value >= 8; value >>= 3) add((value & 7u) | 8u, 4);
    add(value, 4);
  }
  /// Appends the difference of two counts that are usually close.
  constexpr void add_difference(std::uint32_t value, std::uint32_t from) noexcept {
    const std::uint32_t difference = value - from;
    const bool is_negative = (difference >> 31) != 0;
    add_short(is_negative ? 2 * ~difference + 1 : 2 * difference);
  }

  [[nodiscard]] constexpr std::size_t bit_count() const noexcept { return size_; }
  [[nodiscard]] constexpr std::size_t byte_count() const noexcept { return (size_ + 7) / 8; }
  [[nodiscard]] constexpr bool has_room() const noexcept { return byte_count() <= room_.size(); }

 private:
  std::span<std::byte> room_;
  std::size_t size_;
};

/// Reads the output of a `BitWriter`. Past the end it reads zeros and `has_failed`.
class BitReader {
 public:
  constexpr BitReader() noexcept = default;
  explicit constexpr BitReader(std::span<const std::byte> bytes) noexcept : bytes_(bytes) {}

  [[nodiscard]] constexpr std::uint64_t number(int count) noexcept {
    std::uint64_t value = 0;
    for (int i = 0; i < count; ++i, ++position_) {
      const auto at = position_ / 8;
      if (at >= bytes_.size()) {
        has_failed_ = true;
        return 0;
      }
      value |= (std::to_integer<std::uint64_t>(bytes_[at]) >> (position_ % 8) & 1u) << i;
    }
    return value;
  }
  [[nodiscard]] constexpr bool flag() noexcept { return number(1) != 0; }
  /// Fails if the number has more bits than 32 or a group that adds nothing.
  [[nodiscard]] constexpr std::uint32_t short_number() noexcept {
    std::uint64_t value = 0;
    for (int shift = 0; shift < 33; shift += 3) {
      const auto group = number(4);
      value |= (group & 7u) << shift;
      if (group >= 8) continue;
      has_failed_ |= (group == 0 && shift > 0) || (value >> 32) != 0;
      return static_cast<std::uint32_t>(value);
    }
    has_failed_ = true;
    return 0;
  }
  [[nodiscard]] constexpr std::uint32_t difference(std::uint32_t from) noexcept {
    const auto code = short_number();
    return from + (code % 2 != 0 ? ~(code / 2) : code / 2);
  }

  constexpr void fail() noexcept { has_failed_ = true; }
  [[nodiscard]] constexpr bool has_failed() const noexcept { return has_failed_; }
  /// Whether only the zeros that pad the last byte are left.
  [[nodiscard]] constexpr bool is_at_end() noexcept {
    const auto left = 8 * bytes_.size() - position_;
    return !has_failed_ && left < 8 && number(static_cast<int>(left)) == 0;
  }

 private:
  std::span<const std::byte> bytes_;
  std::size_t position_ = 0;
  bool has_failed_ = false;
};

}  // namespace detent::detail
