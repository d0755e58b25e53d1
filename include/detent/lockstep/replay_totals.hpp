// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "detent/lockstep/replay.hpp"

namespace detent {

/// The results of checking many replays. Totals of parts add up to those of the whole, in any
/// order.
///
/// (tests/lockstep/replay_totals.test.cpp)
struct ReplayTotals {
  std::uint64_t files = 0;
  std::uint64_t equal = 0;       // all digests match, up to the end or to where it was cut off
  std::uint64_t different = 0;   // a digest differs
  std::uint64_t unreadable = 0;  // not a replay, of another version or game, or a byte has changed
  std::uint64_t cut = 0;         // of the equal ones: the last block is incomplete
  std::uint64_t frames = 0;      // simulated

  constexpr ReplayTotals& operator+=(const ReplayTotals& other) noexcept {
    files += other.files;
    equal += other.equal;
    different += other.different;
    unreadable += other.unreadable;
    cut += other.cut;
    frames += other.frames;
    return *this;
  }
  /// Adds one check.
  constexpr ReplayTotals& operator+=(const ReplayCheck& check) noexcept {
    ++files;
    frames += check.frames;
    const bool is_read = check.state == ReplayState::whole || check.state == ReplayState::cut;
    if (!check.is_equal) {
      ++different;
    } else if (is_read) {
      ++equal;
      cut += check.state == ReplayState::cut ? 1 : 0;
    } else {
      ++unreadable;
    }
    return *this;
  }
  [[nodiscard]] friend constexpr bool operator==(const ReplayTotals&,
                                                 const ReplayTotals&) noexcept = default;
};

/// Whether a file of this name belongs to shard `shard`, 1 to `shards`: each name is in exactly
/// one, the same on every machine.
[[nodiscard]] constexpr bool is_in_shard(std::string_view name, std::uint32_t shard,
                                         std::uint32_t shards) noexcept {
  Digest digest;
  for (const char c : name) digest.add(static_cast<std::uint8_t>(c));
  return shards != 0 && digest.value() % shards + 1 == shard;
}

}  // namespace detent
