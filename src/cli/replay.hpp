// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "detent/lockstep/replay_totals.hpp"

namespace detent::cli {

struct ReplayOptions {
  std::vector<std::string> paths;  // files, and folders of them
  std::string shard = "1/1";
};

/// The result of checking replays: a line for each file with a problem, and the totals.
struct ReplayReport {
  std::vector<std::string> problems;
  ReplayTotals totals;
};

/// Simulates replays of the example world again: those of the shard, by name. Throws InputError if
/// a path does not exist or the shard is invalid.
[[nodiscard]] ReplayReport check_replays(const ReplayOptions& options);

/// `detent replay check`: prints the report; the exit code (docs/tool.md).
[[nodiscard]] int replay_check(const ReplayOptions& options);

struct ExampleOptions {
  std::string out;
  std::uint64_t seed = 1;
  int frames = 3600;
  int every = 60;
};

/// The bytes of a replay of the example world: two players whose balls push blocks about.
[[nodiscard]] std::string example_replay(const ExampleOptions& options);

/// `detent replay example`: writes such a replay (docs/tool.md).
void replay_example(const ExampleOptions& options);

}  // namespace detent::cli
