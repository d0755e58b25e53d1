// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

#include "detent/number/require_cxx20.hpp"

namespace detent::detail {

/// Estimates by how many frames this peer is ahead of another, without clocks.
///
/// Each peer sees the other's frame as it was when the packet left, so both estimates are too high
/// by the latency; half their difference cancels it. Both are smoothed over about 16 frames.
class TimeSync {
 public:
  /// Counts a frame: `ahead` is our frame minus the other peer's last known one.
  constexpr void count(std::int32_t ahead) noexcept {
    ours_ += (std::clamp(ahead, -limit, limit) * unit - ours_) / smoothing;
  }
  /// Takes the other peer's estimate, from a packet.
  constexpr void hear(std::uint32_t ahead) noexcept {
    theirs_ = (static_cast<std::int32_t>(ahead) - bias) * unit;
  }
  /// Our estimate, for a packet.
  [[nodiscard]] constexpr std::uint32_t said() const noexcept {
    const auto rounded = (ours_ + (ours_ < 0 ? -unit / 2 : unit / 2)) / unit;
    return static_cast<std::uint32_t>(rounded + bias);
  }
  /// How many frames this peer is ahead by, rounded towards zero.
  [[nodiscard]] constexpr std::int32_t lead() const noexcept {
    return (ours_ - theirs_) / (2 * unit);
  }

 private:
  static constexpr std::int32_t bias = 128, limit = 127, unit = 256, smoothing = 16;

  std::int32_t ours_ = 0, theirs_ = 0;  // in 1/256 frame
};

/// Makes the peer that is ahead wait: at most one frame in `spacing`, so that it is not visible,
/// and a peer that lies about its frame slows the others by no more.
class Waiting {
 public:
  static constexpr std::uint32_t spacing = 8;

  /// Whether this frame should wait, given the largest lead over another peer.
  [[nodiscard]] constexpr bool should_wait(std::int32_t lead) noexcept {
    ++since_;
    if (lead < 1 || since_ < spacing) return false;
    since_ = 0;
    return true;
  }

 private:
  std::uint32_t since_ = 0;
};

}  // namespace detent::detail
