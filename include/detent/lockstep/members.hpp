// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "detent/lockstep/peer.hpp"

namespace detent::detail {

/// Which players take part, and the frame from which a dropped player counts as absent.
///
/// The remaining peers must use the same inputs of a dropped player, although each received a
/// different number of them. A peer that drops a player accepts no more packets from it, announces
/// this in every packet, and forwards the player's inputs to peers that have fewer. Every peer that
/// learns of the drop does the same; the dropped player continues alone. Once all remaining peers
/// have dropped the same players and hold equally many inputs, none can ever get another one: that
/// number is the first frame without the player. Every remaining peer eventually sees this, even if
/// one of them is dropped in the meantime. (tests/lockstep/drop_out.test.cpp)
class Members {
 public:
  constexpr Members(std::size_t self, std::size_t players) noexcept
      : self_(self), players_(players) {}

  [[nodiscard]] constexpr std::uint32_t dropped() const noexcept { return dropped_; }
  [[nodiscard]] constexpr bool is_dropped(std::size_t player) const noexcept {
    return player < players_ && ((dropped_ >> player) & 1u) != 0;
  }
  constexpr void drop(std::size_t player) noexcept { dropped_ |= 1u << player; }
  /// Marks a seat as free from `end` on.
  constexpr void leave_empty(std::size_t player, std::uint32_t end) noexcept {
    drop(player);
    ends_[player] = end;
  }
  /// How often the seat was reassigned. Statements about an earlier term are void.
  [[nodiscard]] constexpr std::uint8_t term(std::size_t player) const noexcept {
    return terms_[player];
  }
  [[nodiscard]] constexpr const std::array<std::uint8_t, most_players>& terms() const noexcept {
    return terms_;
  }
  constexpr void set_term(std::size_t player, std::uint8_t term, std::uint32_t begin) noexcept {
    terms_[player] = term;
    begins_[player] = begin;
  }
  /// The first frame of the player's current term; 0 in the first.
  [[nodiscard]] constexpr std::uint32_t begin(std::size_t player) const noexcept {
    return begins_[player];
  }
  /// Whether the seat is free, and may be given, in a frame whose inputs are known.
  [[nodiscard]] constexpr bool is_free(std::size_t player, std::uint32_t frame) const noexcept {
    return ends_[player] && *ends_[player] <= frame && terms_[player] < 255;
  }
  /// Gives the seat to a player who takes part from `frame` on.
  constexpr void admit(std::size_t player, std::uint32_t frame) noexcept {
    dropped_ &= ~(1u << player);
    ends_[player].reset();
    begins_[player] = frame;
    ++terms_[player];
  }

  /// The first frame without a player's input, once agreed.
  [[nodiscard]] constexpr const std::optional<std::uint32_t>& end(
      std::size_t player) const noexcept {
    return ends_[player];
  }

  /// Whether this player continues, or waits for `peers` to agree on its end.
  template <class Peers>
  [[nodiscard]] constexpr bool agrees(const Peers& peers, std::size_t other, std::size_t player,
                                      std::uint32_t held) const noexcept {
    return other == self_ || is_dropped(other) ||
           (peers[other].dropped == dropped_ && peers[other].held[player] == held);
  }
  /// Ends a dropped player at `held` inputs if all agree; returns whether that happened now.
  template <class Peers>
  [[nodiscard]] constexpr bool agree(const Peers& peers, std::size_t player,
                                     std::uint32_t held) noexcept {
    if (!is_dropped(player) || ends_[player]) return false;
    for (std::size_t other = 0; other < players_; ++other) {
      if (!agrees(peers, other, player, held)) return false;
    }
    ends_[player] = held;
    return true;
  }

 private:
  std::size_t self_, players_;
  std::uint32_t dropped_ = 0;
  std::array<std::optional<std::uint32_t>, most_players> ends_{};
  std::array<std::uint8_t, most_players> terms_{};
  std::array<std::uint32_t, most_players> begins_{};
};

}  // namespace detent::detail
