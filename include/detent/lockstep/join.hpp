// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "detent/lockstep/session.hpp"

// How a peer joins late, or rejoins. It requests a snapshot from one player and gets it in slices;
// then it follows the match as a spectator. A seat is given by a word in the input of a player, so
// all peers learn of it in the same frame, whichever packets are lost:
//
// * The word is in the input of frame f; the player takes part from frame f + `notice` on. Every
//   peer that knows all inputs of frame f acts on it before it simulates frame f + `notice`,
//   because predictions reach at most `prediction` <= 16 frames beyond the known inputs.
// * It counts only if the seat is free in frame f. All peers that know that frame agree on this.
// * A guest holds only inputs that some player also holds. So players that agree on a dropped
//   player's end without the guest hold at least its inputs: the argument in members.hpp still
//   holds.

namespace detent {

/// Acts on inputs that give seats, once all inputs of their frame are known.
template <RollbackWorld World, class Input, SessionLimits Limits>
void Session<World, Input, Limits>::admit() {
  std::uint32_t end = 0;
  for (std::size_t i = 0; i < config_.players; ++i) end = (std::max)(end, queues_[i].count());
  for (; admitted_ < (std::min)(known(), end); ++admitted_) {
    for (std::size_t i = 0; i < config_.players; ++i) {
      const auto& left = members_.end(i);
      if ((left && *left <= admitted_) || !queues_[i].has(admitted_)) continue;
      const auto word = std::to_integer<std::size_t>(queues_[i][admitted_].back());
      if (word == 0 || word > config_.players) continue;
      if (members_.is_free(word - 1, admitted_)) let_in(word - 1, admitted_ + notice);
    }
  }
}

/// Admits a player from `frame` on.
template <RollbackWorld World, class Input, SessionLimits Limits>
void Session<World, Input, Limits>::let_in(std::size_t seat, std::uint32_t frame) {
  members_.admit(seat, frame);
  queues_[seat].skip_to(frame);
  for (auto& other : peers_) {
    other.dropped &= ~(1u << seat);
    other.comparison.forget_waiting();
  }
  detail::Peer& peer = peers_[seat];
  if (seat == config_.self) {
    is_guest_ = false;
  } else if (peer.is_guest) {
    peer.is_guest = false;
  } else {
    const auto life = peer.life;
    peer = detail::Peer{};
    peer.life = life;
    peer.awaits_life = true;
  }
  tell(Kind::joined, seat, frame);
}

/// The word of our next input: a seat for a guest who has caught up, if we are the first player.
template <RollbackWorld World, class Input, SessionLimits Limits>
std::byte Session<World, Input, Limits>::invitation() {
  for (std::size_t i = 0; i < config_.self; ++i) {
    if (!members_.is_dropped(i)) return detail::no_word;
  }
  const auto frame = own().count();
  for (std::size_t i = 0; i < config_.players; ++i) {
    detail::Peer& peer = peers_[i];
    const bool is_ready = peer.is_guest && peer.is_started && peer.join.wants_seat &&
                          !peer.is_silent && peer.frame + 2 * notice >= final_frame();
    if (!is_ready || !members_.is_free(i, final_frame()) || frame < peer.invited_until) continue;
    peer.invited_until = frame + 4 * notice;
    return static_cast<std::byte>(i + 1);
  }
  return detail::no_word;
}

/// Updates a peer whose packet has a different life number; returns whether the packet is of its
/// current life.
template <RollbackWorld World, class Input, SessionLimits Limits>
bool Session<World, Input, Limits>::meet(std::size_t peer, const detail::Packet& packet) {
  const auto life = packet.join ? packet.join->life : 0;
  detail::Peer& from = peers_[peer];
  if (from.awaits_life && life >= from.life) {
    from.awaits_life = false;
    from.life = life;
  }
  if (life < from.life) return false;
  // A peer without a world does not play either: the seat belonged to its previous session.
  const bool is_empty = peer < config_.players && !from.is_guest && !from.is_started &&
                        packet.join && !packet.join->is_loaded;
  if (life == from.life && !is_empty) return true;
  if (peer < config_.players && !members_.is_dropped(peer)) drop(peer);
  from = detail::Peer{};
  from.life = life;
  from.is_guest = true;
  tell(Kind::arrived, peer);
  return true;
}

/// Takes a guest's join state; returns whether the rest of its packet is valid yet.
template <RollbackWorld World, class Input, SessionLimits Limits>
bool Session<World, Input, Limits>::hear_guest(std::size_t from, const detail::Packet& packet) {
  if (!packet.join) return true;
  detail::Peer& peer = peers_[from];
  if (peer.is_started) return packet.join->is_loaded;
  peer.join = *packet.join;
  if (!packet.join->is_loaded) return false;
  peer.is_started = true;
  peer.comparison = detail::Comparison(packet.join->start);
  if (outgoing_.is_for(from, peer.life)) outgoing_.stop();
  return true;
}

/// Takes a snapshot for the guest that asks us, unless another guest is being served.
template <RollbackWorld World, class Input, SessionLimits Limits>
void Session<World, Input, Limits>::serve() {
  if constexpr (can_serve) {
    if (!is_player()) return;
    if (outgoing_.is_on()) {
      const detail::Peer& peer = peers_[outgoing_.to()];
      const bool is_there = outgoing_.is_for(outgoing_.to(), peer.life) && peer.is_guest &&
                            !peer.is_started && !peer.is_silent;
      // Inputs after the snapshot must stay stored until the guest has it.
      const bool is_old = outgoing_.frame() + Limits.history * 3 / 4 < own().count();
      if (is_there && !is_old) return;
      outgoing_.stop();
    }
    const auto frame = checksums_.count();
    if (frame == 0 || !timeline_.has_result(frame - 1)) return;
    if (served_ != 0 && frame < served_ + notice) return;  // limits the work that guests can cause
    for (std::size_t i = 0; i < config_.players; ++i) {
      if (members_.begin(i) != 0 && members_.begin(i) >= frame + notice) return;
    }
    // Round robin, so that no guest starves the others.
    for (std::size_t k = 1; k <= peer_count(); ++k) {
      const auto i = (outgoing_.to() + k) % peer_count();
      const detail::Peer& peer = peers_[i];
      const bool asks = i != config_.self && peer.is_guest && !peer.is_started && !peer.is_silent &&
                        peer.join.source == config_.self;
      const bool is_over = i >= config_.players || members_.is_free(i, frame);  // its old life
      if (!asks || !is_over) continue;
      const auto size = write_snapshot(frame, outgoing_.room());
      if (size != 0) outgoing_.start(i, peer.life, frame, size);
      served_ = frame;
      return;
    }
  }
}

/// Writes the match before a final frame: frame 4 bytes, players 1, digest of all frames before 8;
/// for each seat 1 if it is free, else 0, its term 1, the first frame of that term 4, its last
/// input; the world. Returns 0 if there is no room.
template <RollbackWorld World, class Input, SessionLimits Limits>
std::size_t Session<World, Input, Limits>::write_snapshot(std::uint32_t frame,
                                                          std::span<std::byte> room) const {
  if (room.size() < snapshot_head(config_.players)) return 0;
  auto* to = room.data();
  const auto put = [&](auto word) {
    detail::store_word(to, word);
    to += sizeof(word);
  };
  put(frame);
  put(static_cast<std::uint8_t>(config_.players));
  put(checksums_.chain());
  for (std::size_t i = 0; i < config_.players; ++i) {
    const auto& end = members_.end(i);
    put(static_cast<std::uint8_t>(end && *end <= frame ? 1 : 0));
    put(members_.term(i));
    put(members_.begin(i));
    const auto before = queues_[i].has_before(frame) ? queues_[i].before(frame) : Wire{};
    for (const auto byte : before) *to++ = byte;
  }
  const auto rest = room.subspan(snapshot_head(config_.players));
  const std::size_t size = snapshot(timeline_.result(frame - 1), rest);
  return size > rest.size() ? 0 : snapshot_head(config_.players) + size;
}

/// Starts with the received snapshot; returns whether it is valid.
template <RollbackWorld World, class Input, SessionLimits Limits>
bool Session<World, Input, Limits>::read_snapshot(std::span<const std::byte> bytes) {
  const auto head = snapshot_head(config_.players);
  if (bytes.size() < head) return false;
  const auto* from = bytes.data();
  const auto get = [&]<class Word>(Word) {
    const auto word = detail::load_word<Word>(from);
    from += sizeof(Word);
    return word;
  };
  const auto frame = get(std::uint32_t{});
  if (frame == 0 || frame >= last_frame || frame != incoming_.frame()) return false;
  if (get(std::uint8_t{}) != config_.players) return false;
  const auto chain = get(std::uint64_t{});
  auto members = detail::Members(config_.self, config_.players);
  auto queues = queues_;
  for (std::size_t i = 0; i < config_.players; ++i) {
    const auto is_free = get(std::uint8_t{});
    const auto term = get(std::uint8_t{});
    const auto begin = get(std::uint32_t{});
    Wire before{};
    for (auto& byte : before) byte = *from++;
    if (is_free > 1 || begin >= frame + notice) return false;
    members.set_term(i, term, begin);
    if (is_free != 0) members.leave_empty(i, frame);
    queues[i].start(frame, before);
    queues[i].skip_to((std::max)(frame, begin));
  }
  if (members.dropped() == (1u << config_.players) - 1) return false;  // nobody plays
  if (config_.self < config_.players && !members.is_dropped(config_.self)) return false;
  const auto load = [&](World& world) {
    if constexpr (can_serve) {
      const auto restored = restore(world, bytes.subspan(head));
      if constexpr (std::same_as<std::remove_cv_t<decltype(restored)>, bool>) {
        return restored;
      } else {
        return restored == Restored::yes;
      }
    } else {
      return false;
    }
  };
  if (!timeline_.start(frame, load)) return false;
  members_ = members;
  queues_ = queues;
  checksums_.start(frame, chain);
  for (auto& peer : peers_) peer.comparison = detail::Comparison(frame);
  for (std::size_t i = 0; i < config_.players; ++i) {
    if (members_.is_dropped(i)) continue;
    peers_[i].is_guest = false;  // it also joined late, and already plays
    peers_[i].awaits_life = members_.term(i) > 0 && peers_[i].life == 0;
  }
  simulated_ = admitted_ = start_ = frame_ = frame;
  is_loading_ = false;
  return true;
}

/// Handles packets before we have a world.
template <RollbackWorld World, class Input, SessionLimits Limits>
void Session<World, Input, Limits>::load(std::size_t from, const detail::Packet& packet,
                                         std::uint64_t now) {
  const bool is_first = !source_;
  const bool is_better = from < config_.players && from != config_.self && is_first;
  if (is_better) {
    source_ = from;
    progress_ = now;
  }
  if (!packet.slice || source_ != from) return;
  if (incoming_.take(*packet.slice)) progress_ = now;
  if (!incoming_.is_whole()) return;
  if (read_snapshot(incoming_.bytes())) {
    tell(Kind::loaded, from, frame_);
  } else {
    tell(Kind::no_snapshot, from);
    ask_another(now);
  }
}

/// Asks the next player that was heard.
template <RollbackWorld World, class Input, SessionLimits Limits>
void Session<World, Input, Limits>::ask_another(std::uint64_t now) {
  incoming_.forget();
  progress_ = now;
  for (std::size_t k = 1; k <= config_.players && source_; ++k) {
    const auto i = (*source_ + k) % config_.players;
    if (i == config_.self || !peers_[i].is_heard || peers_[i].is_silent) continue;
    source_ = i;
    return;
  }
}

/// Our join state, if we joined late.
template <RollbackWorld World, class Input, SessionLimits Limits>
std::optional<detail::JoinState> Session<World, Input, Limits>::join_state() const {
  if (config_.life == 0) return std::nullopt;
  detail::JoinState join;
  join.life = config_.life;
  join.wants_seat = is_guest_ && config_.wants_seat && config_.self < config_.players;
  join.is_loaded = !is_loading_;
  join.start = start_;
  join.source = source_.value_or(most_peers_mark);
  if (is_loading_) incoming_.describe(join);
  return join;
}

}  // namespace detent
