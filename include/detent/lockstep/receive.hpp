// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "detent/lockstep/session.hpp"

// How a session handles packets.

namespace detent {

template <RollbackWorld World, class Input, SessionLimits Limits>
Received Session<World, Input, Limits>::receive(std::size_t peer, std::span<const std::byte> bytes,
                                                std::uint64_t now) {
  timeline_.discard();
  if (bytes.size() > Limits.packet || peer >= peer_count() || peer == config_.self) {
    return Received::other_match;
  }
  const auto header = detail::PacketHeader::read(bytes, config_.match);
  if (!header || header->sender != peer) return Received::other_match;
  const auto packet =
      detail::Packet::read<Input>(bytes.subspan(detail::PacketHeader::size), config_.players);
  if (!packet) return Received::malformed;
  if (!meet(peer, *packet) || !is_met(peer)) {
    peers_[peer].owes_notice = true;
    return Received::dropped;
  }
  if (is_player() && packet->held[config_.self] > own().count()) return Received::malformed;

  detail::Peer& from = peers_[peer];
  if (!from.is_heard) tell(Kind::connected, peer);
  if (from.is_silent) tell(Kind::heard_again, peer);
  from.is_heard = true;
  from.is_silent = false;
  from.last_heard = now;
  if (is_loading_) {
    load(peer, *packet, now);
  } else {
    apply(peer, *packet);
  }
  return Received::yes;
}

template <RollbackWorld World, class Input, SessionLimits Limits>
void Session<World, Input, Limits>::apply(std::size_t from, const detail::Packet& packet) {
  detail::Peer& peer = peers_[from];
  if (!hear_guest(from, packet)) return;
  const bool was_paused = peer.is_paused;
  peer.hear(packet, config_.players);
  if (peer.is_paused != was_paused) tell(peer.is_paused ? Kind::paused : Kind::resumed, from);
  if (from < config_.players && !peer.is_guest) {
    // Only drops in the current terms count. If the sender knows a later term of a player, that
    // player was dropped in the current one.
    std::uint32_t dropped = 0;
    for (std::size_t i = 0; i < config_.players; ++i) {
      const auto bit = 1u << i;
      if (packet.terms[i] == members_.term(i)) dropped |= packet.dropped & bit;
      if (packet.terms[i] > members_.term(i)) dropped |= bit;
    }
    // A player dropped by one peer is dropped by all; a player that learns that it was dropped
    // continues alone.
    if (is_player() && ((dropped >> config_.self) & 1u) != 0) {
      tell(Kind::expelled, from);
      is_expelled_ = true;
      for (std::size_t i = 0; i < config_.players; ++i) drop(i);
      return;
    }
    peer.dropped |= dropped;
    for (std::size_t i = 0; i < config_.players; ++i) {
      if (i != from && ((dropped >> i) & 1u) != 0 && !members_.is_dropped(i)) drop(i);
    }
  }
  for (std::size_t i = 0; i < packet.run_count; ++i) {
    const auto player = packet.runs[i].player;
    if (packet.terms[player] == members_.term(player)) take(from, packet.runs[i]);
  }
  agree();
  if (!is_player() && !is_lost_ && from < config_.players && !peer.is_guest &&
      packet.frame > queues_[from].count() + Limits.history) {
    is_lost_ = true;
    tell(Kind::too_slow, config_.self);
  }
  compare(from, packet);
}

/// Takes inputs: each player's from itself, those of a dropped player from the remaining peers.
template <RollbackWorld World, class Input, SessionLimits Limits>
void Session<World, Input, Limits>::take(std::size_t from, detail::InputRun run) {
  const auto player = run.player;
  if (peers_[from].is_guest || members_.end(player)) return;
  const bool is_passed_on = from < config_.players && player != config_.self &&
                            members_.is_dropped(player) && !members_.end(player);
  if (player != from && !is_passed_on) return;
  Queue& queue = queues_[player];
  if (run.first > queue.count() || !queue.has_before(run.first)) return;
  auto most = final_frame() + lead;
  for (std::size_t i = 0; is_guest_ && i < config_.players; ++i) {
    if (i != player && i != config_.self && !members_.is_dropped(i)) {
      most = (std::min)(most, peers_[i].held[player]);
    }
  }
  Wire bytes = queue.before(run.first);
  for (std::uint32_t i = 0; i < run.count; ++i) {
    const auto frame = run.first + i;
    detail::unpack(run.bits, bytes);
    const auto input = detail::canonical_wire<Input>(bytes, config_.players);
    if (frame < queue.count()) {
      if (!queue.has(frame) || queue[frame] == input) continue;
      if (!peers_[from].has_contradicted) tell(Kind::contradiction, from, frame);
      peers_[from].has_contradicted = true;
      return;
    }
    if (frame >= most) return;
    queue.push(input);
    if (frame < timeline_.done() &&
        timeline_.used(frame)[player] != detail::input_of<Input>(input)) {
      timeline_.go_back(frame);
    }
  }
}

template <RollbackWorld World, class Input, SessionLimits Limits>
void Session<World, Input, Limits>::compare(std::size_t from, const detail::Packet& packet) {
  detail::Peer& peer = peers_[from];
  if (packet.dropped != members_.dropped()) return;  // it may still play with others
  if (peer.comparison.compare(packet.digests, checksums_)) found_desync(from);
  if (!packet.fields || !peer.comparison.has_found() || !odd_ ||
      peer.comparison.found() != odd_frame_) {
    return;
  }
  with_evidence(odd_frame_, [&](const auto& evidence) {
    const auto found = peer.search.hear(*packet.fields, evidence);
    if (!found) return;
    SessionEvent event{Kind::desync_field, from, odd_frame_, {}, {}};
    if (const auto place = detail::place_of(evidence, detail::Fields::all, *found)) {
      event.field = place->name;
      if (place->object) event.object = place->object->id;
    }
    events_.push(event);
  });
}

/// Reports the first frame that differs at a peer, and stores our result of it.
template <RollbackWorld World, class Input, SessionLimits Limits>
void Session<World, Input, Limits>::found_desync(std::size_t peer) {
  const auto frame = peers_[peer].comparison.found();
  tell(Kind::desync, peer, frame);
  peers_[peer].search.start(frame);
  if (odd_ || !timeline_.has_result(frame)) return;
  odd_ = timeline_.result(frame);
  odd_inputs_ = timeline_.used(frame);
  odd_frame_ = frame;
}

template <RollbackWorld World, class Input, SessionLimits Limits>
template <class Visit>
void Session<World, Input, Limits>::with_evidence(std::uint32_t frame, const Visit& visit) const {
  if (odd_ && odd_frame_ == frame) {
    visit(detail::Evidence<World, typename Timeline::Used>{odd_inputs_, *odd_});
  }
}

}  // namespace detent
