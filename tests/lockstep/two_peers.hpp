// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "detent/lockstep/session.hpp"

namespace detent::test {

/// Two peers, and the last events of each that tell of a desync.
template <class Match>
struct TwoPeers {
  std::array<std::unique_ptr<Match>, 2> peers;
  std::array<std::optional<SessionEvent>, 2> desync, field;
};

/// Plays 120 ticks of a match of two peers who receive each other's messages a tick later.
/// step(peer, state, inputs) advances the state of a peer by a frame.
template <class Match, class State, class Step>
TwoPeers<Match> play(SessionConfig config, const State& start, const Step& step) {
  TwoPeers<Match> result;
  for (std::size_t i = 0; i < 2; ++i) {
    config.self = i;
    result.peers[i] = std::make_unique<Match>(config, start);
  }
  std::array<std::vector<std::byte>, 2> wire;  // to each
  for (std::uint64_t tick = 0; tick < 120; ++tick) {
    const auto now = tick * 16'667;
    for (std::size_t i = 0; i < 2; ++i) {
      if (!wire[i].empty()) result.peers[i]->receive(1 - i, wire[i], now);
    }
    for (std::size_t i = 0; i < 2; ++i) {
      auto& peer = *result.peers[i];
      const auto input = static_cast<std::int8_t>(static_cast<int>(tick / (4 + i) % 3) - 1);
      peer.advance(input, [&](State& state, const typename Match::Inputs& inputs) {
        step(i, state, inputs);
      });
      peer.poll(now, [&](std::size_t to, std::span<const std::byte> bytes) {
        wire[to].assign(bytes.begin(), bytes.end());
      });
      while (const auto event = peer.next_event()) {
        if (event->kind == SessionEvent::Kind::desync) result.desync[i] = event;
        if (event->kind == SessionEvent::Kind::desync_field) result.field[i] = event;
      }
    }
  }
  return result;
}

}  // namespace detent::test
