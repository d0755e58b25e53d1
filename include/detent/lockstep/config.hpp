// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "detent/number/assert.hpp"

namespace detent {

/// The sizes of a session's inline storage.
struct SessionLimits {
  std::size_t players = 8;      // at most 8
  std::size_t peers = 16;       // players and spectators, at most 16
  std::size_t prediction = 16;  // frames that may be simulated with predicted inputs, at most 16
  std::size_t evidence = 32;    // final results that are stored, to name differences
  std::size_t history = 128;    // frames whose inputs are stored, at least 128
  std::size_t events = 64;
  std::size_t packet = 1200;  // bytes of the largest packet, at least 512
  std::size_t snapshot = 0;   // bytes of the largest snapshot, for late joiners; 0: none

  [[nodiscard]] constexpr bool is_valid() const noexcept {
    return players >= 1 && players <= 8 && peers >= players && peers <= 16 && prediction <= 16 &&
           history >= 128 && events >= 1 && packet >= 512 && packet <= 2000 &&
           snapshot <= (std::size_t{1} << 24);
  }
};

/// A match and one peer in it. Times are in microseconds, of a clock that only this peer needs.
struct SessionConfig {
  std::uint64_t match = 0;  // the same for all peers: a random number, chosen by the host
  std::size_t self = 0;     // peers are numbered: players first, then spectators
  std::size_t players = 2;
  std::size_t spectators = 0;
  std::uint32_t delay = 2;               // frames between an input and its effect, 0 to 8
  std::uint32_t prediction = 8;          // 0: every frame waits for all inputs (pure lockstep)
  std::uint64_t send_interval = 10'000;  // at least this long between two packets to a peer
  std::uint64_t silence = 2'000'000;     // a peer that sends nothing for this long is `silent`
  std::uint32_t frames_per_call = 17;    // the most that `advance` simulates, at least 1
  std::uint32_t absent = 0;  // free seats at the start, one bit each: the same for all peers
  // 0 for a peer that is present from the start. One that joins late or rejoins uses a number
  // greater than in its earlier sessions of this match, such as the time in seconds.
  std::uint32_t life = 0;
  bool wants_seat = true;  // whether a late player wants to play, or only to watch

  /// The nearest config that these limits allow; without prediction the delay is at least 1.
  [[nodiscard]] constexpr SessionConfig within(const SessionLimits& limits) const noexcept {
    SessionConfig result = *this;
    result.players = std::clamp(players, std::size_t{1}, limits.players);
    result.spectators = (std::min)(spectators, limits.peers - result.players);
    result.self = (std::min)(self, result.players + result.spectators - 1);
    result.prediction = (std::min)(prediction, static_cast<std::uint32_t>(limits.prediction));
    result.delay = std::clamp<std::uint32_t>(delay, result.prediction == 0 ? 1 : 0, 8);
    result.frames_per_call = (std::max<std::uint32_t>)(frames_per_call, 1);
    return result;
  }
};

}  // namespace detent
