// SPDX-License-Identifier: MIT
#pragma once

#include "players.hpp"

namespace slingshot {

inline constexpr std::uint64_t golden_seed = 2026;
inline constexpr std::uint32_t golden_delay = 2;  // frames between a key and its effect

/// A digest of the digests of all worlds so far, as in a session.
[[nodiscard]] constexpr std::uint64_t chained(std::uint64_t chain, const Match& match) {
  detent::Digest digest(chain);
  digest.add(detent::detail::WorldDigest(match).all());
  return digest.value();
}

/// Plays the match of simulated players without a network. Calls print(frames, digest) every 600
/// frames.
template <class Print>
constexpr void play_steps(Match& match, std::uint32_t frames, const Print& print) {
  std::uint64_t chain = 0;
  for (std::uint32_t frame = 0; frame < frames; ++frame) {
    std::array<Pad, most_players> pads{};
    for (std::size_t i = 0; i < match.players && frame >= golden_delay; ++i) {
      pads[i] = simulated_pad(golden_seed, i, frame - golden_delay);
    }
    step(match, pads);
    chain = chained(chain, match);
    if ((frame + 1) % 600 == 0) print(frame + 1, chain);
  }
}

}  // namespace slingshot
