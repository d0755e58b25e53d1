// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "rules.hpp"

namespace slingshot {

/// The input of a simulated player in a frame: a function of the seed, so that every program plays
/// the same match. It aims at a new point every one and a half seconds, then shoots.
[[nodiscard]] constexpr Pad simulated_pad(std::uint64_t seed, std::size_t player,
                                          std::uint32_t frame) noexcept {
  constexpr std::uint32_t turn = 90, aiming = 60;
  const std::size_t side = player % 2, is_in_front = player / 2;
  const auto aim = [&](std::uint32_t number) {
    std::uint64_t bits = seed + 2 * number + side + 1 + (std::uint64_t{is_in_front} << 32);
    for (int i = 0; i < 3; ++i) bits = (bits ^ (bits >> 31)) * 0x9e3779b97f4a7c15u;
    Pad pad;
    pad.angle = static_cast<std::int16_t>(6000 + (bits >> 40) % 5000);
    pad.power = static_cast<std::uint8_t>(178 - 12 * is_in_front + (bits >> 20) % 36);
    return pad;
  };
  const std::uint32_t shifted = frame + static_cast<std::uint32_t>(45 * side + 22 * is_in_front);
  const auto from = aim(shifted / turn), to = aim(shifted / turn + 1);
  const int phase = static_cast<int>(shifted % turn);
  const int share = phase < static_cast<int>(aiming) ? phase : static_cast<int>(aiming);
  const auto between = [&](int a, int b) { return a + (b - a) * share / static_cast<int>(aiming); };
  Pad pad;
  pad.angle = static_cast<std::int16_t>(between(from.angle, to.angle));
  pad.power = static_cast<std::uint8_t>(between(from.power, to.power));
  pad.fire = phase > 80;
  return pad;
}

}  // namespace slingshot
