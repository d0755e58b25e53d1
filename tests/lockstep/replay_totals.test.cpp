// SPDX-License-Identifier: MIT
#include "detent/lockstep/replay_totals.hpp"

#include <array>
#include <string>

#include "support/catch.hpp"

using namespace detent;

namespace {

ReplayCheck check_of(ReplayState state, std::uint32_t frames, bool is_equal) {
  return {state, frames, is_equal ? frames : 0, is_equal};
}

}  // namespace

TEST_CASE("replay totals: each check counts once, by its outcome") {
  ReplayTotals totals;
  totals += check_of(ReplayState::whole, 100, true);
  totals += check_of(ReplayState::cut, 20, true);
  totals += check_of(ReplayState::whole, 60, false);
  totals += check_of(ReplayState::corrupted, 7, true);
  totals += check_of(ReplayState::corrupted, 9, false);
  totals += check_of(ReplayState::no_replay, 0, true);
  totals += check_of(ReplayState::other_inputs, 0, true);
  totals += check_of(ReplayState::other_results, 0, true);
  CHECK(totals == ReplayTotals{8, 2, 2, 4, 1, 196});
  auto twice = totals;
  twice += totals;
  CHECK(twice == ReplayTotals{16, 4, 4, 8, 2, 392});
}

TEST_CASE("replay totals: every name is in one shard, and shards have similar sizes") {
  for (const std::uint32_t shards : {1u, 2u, 7u, 16u}) {
    std::array<int, 17> sizes{};
    for (int i = 0; i < 3200; ++i) {
      const auto name = "match-" + std::to_string(i) + ".replay";
      int found = 0;
      for (std::uint32_t shard = 1; shard <= shards; ++shard) {
        if (!is_in_shard(name, shard, shards)) continue;
        ++found;
        ++sizes[shard];
      }
      REQUIRE(found == 1);
    }
    for (std::uint32_t shard = 1; shard <= shards; ++shard) {
      CHECK(sizes[shard] > 3200 / static_cast<int>(shards) * 3 / 4);
    }
  }
  CHECK_FALSE(is_in_shard("a", 1, 0));
  CHECK(is_in_shard("match-1.replay", 1, 2) != is_in_shard("match-1.replay", 2, 2));
}
