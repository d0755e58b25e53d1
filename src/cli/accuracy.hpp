// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

namespace detent::cli {

struct AccuracyOptions {
  std::string markdown;  // files to write; empty for none
  std::string json;
  std::string svg;
  std::string only;  // queries whose name begins so
  int count = 2000;
  std::uint64_t seed = 1;
};

/// Asks every raycast and overlap in every scalar at a ladder of scales, has each answer judged by
/// exact arithmetic, and reports. Without a file to write, the tables go to standard output.
///
/// Whether every fixed-point answer was the exact one, rounded once.
[[nodiscard]] bool measure_accuracy(const AccuracyOptions& options);

}  // namespace detent::cli
