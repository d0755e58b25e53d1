// SPDX-License-Identifier: MIT
#pragma once

#include <detent/lockstep/session.hpp>

#include "rules.hpp"
#include "snapshot.hpp"

namespace slingshot {

inline constexpr std::size_t most_spectators = 4;

/// Two or four players with a prediction of up to 8 frames. Evidence is kept long enough to name a
/// desync after half a second of delay. Late joiners get a snapshot. A spectator may fall behind by
/// 17 s.
inline constexpr detent::SessionLimits limits{.players = most_players,
                                              .peers = most_players + most_spectators,
                                              .prediction = 8,
                                              .evidence = 30,
                                              .history = 1024,
                                              .packet = 512,
                                              .snapshot = snapshot_room};
using Session = detent::Session<Match, Pad, limits>;

inline constexpr auto simulate = [](Match& match, const Session::Inputs& pads) {
  step(match, pads);
};

/// Begins a session that no spectator has joined yet. With a `life`, this peer joins late itself.
inline void begin(Session& session) {
  const auto& config = session.config();
  for (std::size_t i = 0; config.life == 0 && i < config.spectators; ++i) {
    session.drop(config.players + i);
  }
  while (session.next_event()) {
  }
}

}  // namespace slingshot
