// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "detent/lockstep/session.hpp"

// How a session advances.

namespace detent {

/// The number of frames for which one player's inputs are known; all, once its departure is agreed.
/// The agreed end is never below what a remaining player holds, so a player uses all inputs it has;
/// a spectator counts only inputs that all other players hold.
template <RollbackWorld World, class Input, SessionLimits Limits>
std::uint32_t Session<World, Input, Limits>::known_of(std::size_t player) const {
  if (members_.end(player)) return last_frame + lead;
  auto known = queues_[player].count();
  if (is_player()) return known;
  for (std::size_t i = 0; i < config_.players; ++i) {
    if (i == player || members_.is_dropped(i)) continue;
    known = (std::min)(known, peers_[i].held[player]);
  }
  return known;
}

template <RollbackWorld World, class Input, SessionLimits Limits>
std::uint32_t Session<World, Input, Limits>::known_of_others() const {
  auto known = last_frame;
  for (std::size_t i = 0; i < config_.players; ++i) {
    if (i != config_.self) known = (std::min)(known, known_of(i));
  }
  return known;
}

template <RollbackWorld World, class Input, SessionLimits Limits>
std::uint32_t Session<World, Input, Limits>::known() const {
  const auto others = known_of_others();
  return is_player() ? (std::min)(others, queues_[config_.self].count()) : others;
}

/// Whether no player is left, as seen by a spectator.
template <RollbackWorld World, class Input, SessionLimits Limits>
bool Session<World, Input, Limits>::is_deserted() const {
  if (is_player()) return false;
  for (std::size_t i = 0; i < config_.players; ++i) {
    if (!members_.is_dropped(i)) return false;
  }
  return true;
}

/// The inputs of a frame: known ones and predictions.
template <RollbackWorld World, class Input, SessionLimits Limits>
auto Session<World, Input, Limits>::inputs_of(std::uint32_t frame) const -> Used {
  Used used{Inputs(frame, config_.players)};
  for (std::size_t i = 0; i < config_.players; ++i) {
    const auto& end = members_.end(i);
    if (end && frame >= *end) {
      used.bytes[i] = detail::bytes_of(Input{});
      continue;
    }
    const auto wire = queues_[i].has(frame) ? queues_[i][frame] : queues_[i].last();
    used.bytes[i] = detail::input_of<Input>(wire);
    if (queues_[i].is_absent(frame)) continue;
    used.inputs.set(i, InputCodec<Input>::read(used.bytes[i].data()));
  }
  return used;
}

/// Opens the next frame that is not simulated.
template <RollbackWorld World, class Input, SessionLimits Limits>
auto Session<World, Input, Limits>::open() -> Inputs {
  const auto used = inputs_of(timeline_.done());
  timeline_.open(used.bytes);
  return used.inputs;
}

template <RollbackWorld World, class Input, SessionLimits Limits>
void Session<World, Input, Limits>::close_frame() {
  if (!is_open()) return;
  timeline_.close();
  ++simulated_;
  --left_;
  while (checksums_.count() < final_frame()) {
    checksums_.add(detent::world_digest(timeline_.result(checksums_.count())));
  }
}

/// Why the next frame cannot be played now.
template <RollbackWorld World, class Input, SessionLimits Limits>
std::optional<Advanced> Session<World, Input, Limits>::obstacle() {
  bool is_paused = is_paused_;
  std::int32_t most_ahead = 0;
  for (std::size_t i = 0; i < config_.players; ++i) {
    if (i == config_.self || members_.is_dropped(i)) continue;
    detail::Peer& peer = peers_[i];
    if (!peer.is_heard && members_.term(i) > 0) continue;  // known_of_others() waits for it
    if (!peer.is_heard) return Advanced::connecting;
    is_paused |= peer.is_paused;
    peer.sync.count(static_cast<std::int32_t>(frame_ - peer.frame));
    most_ahead = (std::max)(most_ahead, peer.sync.lead());
  }
  if (is_paused) return Advanced::paused;
  if (is_deserted() || frame_ >= last_frame) return Advanced::over;
  if (frame_ >= known_of_others() + config_.prediction) return Advanced::starved;
  if (is_player() && waiting_.should_wait(most_ahead)) return Advanced::ahead;
  return std::nullopt;
}

template <RollbackWorld World, class Input, SessionLimits Limits>
auto Session<World, Input, Limits>::open_frame(const Input& input) -> std::optional<Inputs> {
  const auto stop = [&](Advanced why) -> std::optional<Inputs> {
    is_advancing_ = false;
    advanced_ = why;
    return std::nullopt;
  };
  if (!is_advancing_) {
    if (is_loading_) return stop(Advanced::joining);
    agree();
    left_ = config_.frames_per_call;
    is_advancing_ = true;
    has_played_ = false;
  }
  if (timeline_.done() < frame_) {
    if (left_ == 0) return stop(Advanced::catching_up);
    return open();
  }
  // A spectator that fell behind plays several frames.
  constexpr std::uint32_t slack = 8;
  if (has_played_ && (is_player() || left_ == 0 || frame_ + slack >= known_of_others())) {
    for (std::size_t i = 0; i < peer_count(); ++i) {
      if (!is_dropped(i) && peers_[i].comparison.compare_waiting(checksums_)) found_desync(i);
    }
    return stop(Advanced::yes);
  }
  if (!has_played_) {
    if (left_ == 0) return stop(Advanced::catching_up);
    if (const auto why = obstacle()) return stop(*why);
  }
  if (is_player() && own().count() <= frame_ + config_.delay) {
    const auto pressed = detail::canonical<Input>(detail::bytes_of(input));
    own().push(detail::wire_of<Input>(pressed, invitation()));
  }
  ++frame_;
  has_played_ = true;
  return open();
}

template <RollbackWorld World, class Input, SessionLimits Limits>
template <class Simulate>
Advanced Session<World, Input, Limits>::advance(const Input& input, const Simulate& simulate) {
  while (const auto inputs = open_frame(input)) {
    simulate(opened(), *inputs);
    close_frame();
  }
  return advanced_;
}

template <RollbackWorld World, class Input, SessionLimits Limits>
bool Session<World, Input, Limits>::is_awaited(std::size_t player) const {
  if (player >= config_.players || player == config_.self || members_.is_dropped(player)) {
    return false;
  }
  if (!peers_[player].is_heard || peers_[player].is_paused) return true;
  if (frame_ >= known_of(player) + config_.prediction) return true;
  for (std::size_t i = 0; i < config_.players; ++i) {
    if (members_.is_dropped(i) && !members_.end(i) &&
        !members_.agrees(peers_, player, i, queues_[i].count())) {
      return true;
    }
  }
  return false;
}

/// Ends the players on whose last frame all peers agree.
template <RollbackWorld World, class Input, SessionLimits Limits>
void Session<World, Input, Limits>::agree() {
  timeline_.discard();
  for (std::size_t i = 0; i < config_.players; ++i) {
    const auto held = (std::min)(known_of(i), queues_[i].count());
    if (!members_.agree(peers_, i, held)) continue;
    timeline_.go_back(held);
    tell(Kind::left, i, held);
  }
  admit();
}

template <RollbackWorld World, class Input, SessionLimits Limits>
void Session<World, Input, Limits>::drop(std::size_t peer) {
  if (peer >= peer_count() || peer == config_.self || !is_met(peer)) return;
  const bool is_out = is_dropped(peer);
  peers_[peer].is_guest = false;
  if (is_out || is_loading_) return;
  if (peer < config_.players) {
    members_.drop(peer);
  } else {
    peers_[peer].is_gone = true;
  }
  for (auto& other : peers_) other.comparison.forget_waiting();
  tell(Kind::dropped, peer);
  agree();
}

}  // namespace detent
