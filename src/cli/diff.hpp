// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace detent::cli {

/// What tells two snapshots of scenes apart, a line for each number, and whether nothing does.
struct SnapshotDifference {
  std::string text;
  bool is_none = true;
};

/// Compares the bytes of two snapshots; throws InputError, with the name of the file, for bytes
/// that are none, and for snapshots of different kinds of scenes.
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
