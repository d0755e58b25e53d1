// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

namespace detent::cli {

struct AccuracyOptions {
  std::string markdown;  // files to write; empty for none
  std::string json;
  std::string svg;
  std::string only;  // only queries whose name starts with this
  int count = 2000;
  std::uint64_t seed = 1;
};

/// Runs every raycast and overlap in every scalar at a ladder of scales, checks each result with
/// exact arithmetic, and reports. Without a file to write, the tables go to standard output.
///
/// Returns whether every fixed-point result was the exact one, rounded once.
[[nodiscard]] bool measure_accuracy(const AccuracyOptions& options);

}  // namespace detent::cli
