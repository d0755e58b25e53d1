// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "detent/lockstep/checksums.hpp"
#include "detent/lockstep/field_search.hpp"
#include "detent/lockstep/packet.hpp"
#include "detent/lockstep/time_sync.hpp"

namespace detent::detail {

[[nodiscard]] constexpr std::uint64_t elapsed(std::uint64_t now, std::uint64_t since) noexcept {
  return now > since ? now - since : 0;
}

/// The known state of another peer.
struct Peer {
  bool is_heard = false;
  bool is_silent = false;
  bool is_paused = false;
  bool is_gone = false;           // a spectator that fell behind or was dropped
  bool owes_notice = false;       // it sent a packet after it was dropped
  bool has_contradicted = false;  // reported once
  bool is_sent = false;
  std::uint64_t last_heard = 0, last_sent = 0;
  std::uint32_t frame = 0;                         // the latest that it reported
  std::uint32_t dropped = 0;                       // the players that it dropped
  std::array<std::uint32_t, most_players> held{};  // the inputs that it holds
  std::uint32_t proofs_left = 600;                 // packets with evidence of a desync
  std::uint32_t life = 0;                          // of its session
  bool is_guest = false;            // it joined late, and gets all inputs although it does not play
  bool awaits_life = false;         // it got a seat again, and has not been heard since
  bool is_started = false;          // for a late peer: it has loaded a world
  JoinState join;                   // its last join state before it loaded a world
  std::uint32_t invited_until = 0;  // no second invitation before this frame
  TimeSync sync;
  Comparison comparison;
  FieldSearch search;

  /// Takes the values of a packet. They only grow, so packets may arrive in any order.
  constexpr void hear(const Packet& packet, std::size_t players) noexcept {
    for (std::size_t i = 0; i < players; ++i) held[i] = (std::max)(held[i], packet.held[i]);
    if (packet.frame < frame) return;
    frame = packet.frame;
    sync.hear(packet.ahead);
    is_paused = packet.is_paused;
  }
};

}  // namespace detent::detail
