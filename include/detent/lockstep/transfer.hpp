// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "detent/lockstep/packet.hpp"
#include "detent/number/digest.hpp"

// Snapshots in slices, for late peers: docs/lockstep.md.

namespace detent::detail {

/// A snapshot on its way to one guest, in slices of `Size` bytes.
template <std::size_t Room, std::size_t Size>
class Outgoing {
 public:
  /// The storage for a new snapshot.
  [[nodiscard]] constexpr std::span<std::byte> room() noexcept { return bytes_; }
  /// From now on sends the first `total` bytes of `room`: a match before `frame`, for one life of a
  /// peer.
  constexpr void start(std::size_t to, std::uint32_t life, std::uint32_t frame, std::size_t total) {
    to_ = to;
    life_ = life;
    frame_ = frame;
    total_ = total;
    Digest digest;
    digest.add_bytes(std::span<const std::byte>(bytes_).first(total));
    digest_ = digest.value();
    turn_ = 0;
  }
  constexpr void stop() noexcept { total_ = 0; }
  [[nodiscard]] constexpr bool is_on() const noexcept { return total_ != 0; }
  [[nodiscard]] constexpr bool is_for(std::size_t to, std::uint32_t life) const noexcept {
    return is_on() && to == to_ && life == life_;
  }
  [[nodiscard]] constexpr std::size_t to() const noexcept { return to_; }
  [[nodiscard]] constexpr std::uint32_t frame() const noexcept { return frame_; }

  /// The next slice that the guest lacks, in cyclic order.
  [[nodiscard]] constexpr Slice next(const JoinState& guest) noexcept {
    const auto count = static_cast<std::uint32_t>((total_ + Size - 1) / Size);
    const bool is_mine = guest.frame == frame_;
    const std::uint32_t first = is_mine ? guest.first : 0, later = is_mine ? guest.later : 0;
    std::uint32_t index = (std::min)(first, count - 1);
    for (std::uint32_t k = 0; k < window; ++k) {
      const auto ahead = (turn_ + k) % window;
      const bool has = ahead > 0 && ((later >> (ahead - 1)) & 1u) != 0;
      if (first >= count || ahead >= count - first || has) continue;
      index = first + ahead;
      turn_ = ahead + 1;
      break;
    }
    Slice slice{frame_, static_cast<std::uint32_t>(total_), digest_, index, 0, {}, {}};
    const auto at = index * Size;
    slice.size = static_cast<std::uint32_t>((std::min<std::size_t>)(Size, total_ - at));
    slice.bytes = std::span<const std::byte>(bytes_).subspan(at, slice.size);
    return slice;
  }

 private:
  static constexpr std::uint32_t window = 33;

  std::array<std::byte, Room> bytes_{};
  std::size_t to_ = 0, total_ = 0;
  std::uint32_t life_ = 0, frame_ = 0, turn_ = 0;
  std::uint64_t digest_ = 0;
};

/// A snapshot received in slices, in any order. Slices may contain anything: at worst the transfer
/// starts over.
template <std::size_t Room, std::size_t Size>
class Incoming {
 public:
  /// Takes a slice; returns whether it is new.
  [[nodiscard]] constexpr bool take(const Slice& slice) {
    if (slice.total == 0 || slice.total > Room) return false;
    const auto count = (slice.total + Size - 1) / Size;
    if (slice.index >= count) return false;
    const auto at = slice.index * Size;
    if (slice.size != (std::min<std::size_t>)(Size, slice.total - at)) return false;
    if (slice.frame != frame_ || slice.total != total_ || slice.digest != digest_) {
      forget();
      frame_ = slice.frame;
      total_ = slice.total;
      digest_ = slice.digest;
    }
    if (has_[slice.index]) return false;
    has_[slice.index] = true;
    auto bits = slice.bits;
    for (std::size_t i = 0; i < slice.size; ++i) {
      bytes_[at + i] = static_cast<std::byte>(bits.number(8));
    }
    while (first_ < count && has_[first_]) ++first_;
    return true;
  }
  /// Whether all bytes have arrived and match the digest.
  [[nodiscard]] constexpr bool is_whole() const {
    if (total_ == 0 || first_ * Size < total_) return false;
    Digest digest;
    digest.add_bytes(bytes());
    return digest.value() == digest_;
  }
  [[nodiscard]] constexpr std::span<const std::byte> bytes() const noexcept {
    return std::span<const std::byte>(bytes_).first(total_);
  }
  [[nodiscard]] constexpr std::uint32_t frame() const noexcept { return frame_; }
  constexpr void forget() noexcept {
    has_ = {};
    frame_ = first_ = 0;
    total_ = 0;
    digest_ = 0;
  }

  /// Reports the received slices, for the sender.
  constexpr void describe(JoinState& join) const noexcept {
    join.frame = total_ == 0 ? 0 : frame_;
    join.first = first_;
    join.later = 0;
    for (std::uint32_t k = 0; k < 32; ++k) {
      const auto i = first_ + 1 + k;
      if (i < slices && has_[i]) join.later |= std::uint32_t{1} << k;
    }
  }

 private:
  static constexpr std::size_t slices = (Room + Size - 1) / Size;

  std::array<std::byte, Room> bytes_{};
  std::array<bool, slices> has_{};
  std::uint32_t frame_ = 0, first_ = 0;
  std::size_t total_ = 0;
  std::uint64_t digest_ = 0;
};

}  // namespace detent::detail
