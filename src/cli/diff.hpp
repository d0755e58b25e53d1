// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace detent::cli {

/// The difference between two snapshots of scenes: a line per number that differs, and whether there
/// are none.
struct SnapshotDifference {
  std::string text;
  bool is_none = true;
};

/// Compares the bytes of two snapshots; throws InputError with the file's name for bytes that are
/// not a snapshot, and for snapshots of different kinds of scenes.
[[nodiscard]] SnapshotDifference compare_snapshots(const std::string& name_a,
                                                   const std::string& bytes_a,
                                                   const std::string& name_b,
                                                   const std::string& bytes_b);

struct DiffOptions {
  std::string a;
  std::string b;
};

/// `detent diff`: whether the two files hold the same scene (docs/tool.md).
[[nodiscard]] bool diff(const DiffOptions& options);

}  // namespace detent::cli
