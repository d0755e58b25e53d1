// SPDX-License-Identifier: MIT
#pragma once

#include <detent/lockstep/session.hpp>

#include "rules.hpp"

namespace slingshot {

/// Two or four players who guess up to 8 frames ahead. The evidence lets a desync be named after half
/// a second of delay.
inline constexpr detent::SessionLimits limits{
    .players = most_players, .peers = most_players, .prediction = 8, .evidence = 30, .packet = 512};
using Session = detent::Session<Match, Pad, limits>;

inline constexpr auto simulate = [](Match& match, const Session::Inputs& pads) {
  step(match, pads);
};

}  // namespace slingshot
