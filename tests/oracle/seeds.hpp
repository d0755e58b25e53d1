// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <cstdlib>

#include "support/random.hpp"

namespace detent::oracle {

/// The seeds of a run on demand: twenty rounds; DETENT_ORACLE_SEED changes them.
inline std::array<std::uint64_t, 20> demanded_seeds() {
  const char* text = std::getenv("DETENT_ORACLE_SEED");
  test::Random random(text == nullptr ? 0x5eed : std::strtoull(text, nullptr, 0));
  std::array<std::uint64_t, 20> seeds{};
  for (auto& seed : seeds) seed = random.next();
  return seeds;
}

}  // namespace detent::oracle
