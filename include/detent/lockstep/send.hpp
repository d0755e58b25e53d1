// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "detent/lockstep/session.hpp"

// How a session sends.

namespace detent {

template <RollbackWorld World, class Input, SessionLimits Limits>
template <class Send>
void Session<World, Input, Limits>::poll(std::uint64_t now, const Send& send) {
  if (is_loading_) {
    if (source_ && detail::elapsed(now, progress_) >= config_.silence) ask_another(now);
  } else {
    agree();
    serve();
  }
  for (std::size_t to = 0; to < peer_count(); ++to) {
    if (to == config_.self || !is_due(to, now)) continue;
    peers_[to].is_sent = true;
    peers_[to].owes_notice = false;
    peers_[to].last_sent = now;
    std::array<std::byte, Limits.packet> room;
    const auto size = write(to, room);
    send(to, std::span<const std::byte>(room.data(), size));
  }
}

/// Whether a packet should go to this peer now. Also detects its silence.
template <RollbackWorld World, class Input, SessionLimits Limits>
bool Session<World, Input, Limits>::is_due(std::size_t to, std::uint64_t now) {
  detail::Peer& peer = peers_[to];
  if (!peer.is_sent && !peer.is_heard)
    peer.last_heard = now;  // so that a peer that never appears becomes silent
  // A peer that was dropped itself sends no notices: the remaining peers do.
  if (!is_met(to)) return peer.owes_notice && !is_expelled_;
  if (!peer.is_silent && detail::elapsed(now, peer.last_heard) >= config_.silence) {
    peer.is_silent = true;
    tell(Kind::silent, to);
  }
  return !peer.is_sent || detail::elapsed(now, peer.last_sent) >= config_.send_interval;
}

/// Adds a player's inputs from `first` on, as many as fit in `bits`.
template <RollbackWorld World, class Input, SessionLimits Limits>
void Session<World, Input, Limits>::add_run(detail::Packet& packet, std::size_t player,
                                            std::uint32_t first, std::size_t& bits) const {
  constexpr std::size_t head = 3 + 44 + 7;  // bits of a run before its inputs
  const Queue& queue = queues_[player];
  first = (std::max)(first, members_.begin(player));
  if (first >= queue.count() || !queue.has_before(first) || bits < head) return;
  const auto count = queue.fitting(first, detail::InputRun::most, bits - head);
  if (count == 0) return;
  packet.runs[packet.run_count++] = {player, first, count, {}};
  detail::BitWriter measure({});
  queue.write(measure, first, count);
  bits -= head + measure.bit_count();
}

/// Writes our state for a peer; returns the size of the packet.
template <RollbackWorld World, class Input, SessionLimits Limits>
std::size_t Session<World, Input, Limits>::write(std::size_t to, std::span<std::byte> room) {
  detail::Peer& peer = peers_[to];
  detail::Packet packet;
  packet.frame = frame_;
  packet.ahead = peer.sync.said();
  packet.is_paused = is_paused_;
  packet.dropped = members_.dropped();
  for (std::size_t i = 0; i < config_.players; ++i) packet.held[i] = queues_[i].count();
  if (!peer.comparison.has_found()) {
    packet.digests = peer.comparison.next(checksums_);
  } else if (peer.proofs_left > 0) {
    --peer.proofs_left;
    packet.digests = peer.comparison.next(checksums_);
    with_evidence(peer.comparison.found(), [&](const auto& evidence) {
      peer.search.prepare(evidence);
      packet.fields = peer.search.next();
    });
  }
  packet.terms = members_.terms();
  packet.join = join_state();
  if (peer.is_guest && !peer.is_started && outgoing_.is_for(to, peer.life)) {
    packet.slice = outgoing_.next(peer.join);
  }
  detail::BitWriter measure({});
  packet.write(measure, config_.players, [](auto&, const auto&) {});
  std::size_t bits = 8 * (room.size() - detail::PacketHeader::size) - measure.bit_count() - 8;
  if (is_player() && is_met(to) && (!peer.is_guest || peer.is_started)) {
    const auto held = (std::max)(peer.held[config_.self], members_.begin(config_.self));
    if ((to >= config_.players || peer.is_guest) && !own().has_before(held)) {
      peer.is_gone = to >= config_.players;
      peer.is_guest = false;
      tell(Kind::too_slow, to);
    }
    add_run(packet, config_.self, held, bits);
    for (std::size_t i = 0; i < config_.players; ++i) {
      if (i != to && members_.is_dropped(i)) add_run(packet, i, peer.held[i], bits);
    }
  }
  detail::BitWriter out(room.subspan(detail::PacketHeader::size));
  packet.write(out, config_.players, [&](auto& bits_out, const detail::InputRun& run) {
    queues_[run.player].write(bits_out, run.first, run.count);
  });
  const auto size = detail::PacketHeader::size + out.byte_count();
  detail::PacketHeader{config_.self}.seal(room.first(size), config_.match);
  return size;
}

}  // namespace detent
