// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "part_file.hpp"

namespace detent::cli {

/// The bytes of a file; throws InputError when it is missing, a directory or unreadable.
[[nodiscard]] std::string read_file(const std::string& path);

/// A file that appears whole or not at all.
///
/// It is written under a temporary name in the target's folder and renamed by `commit`; without
/// `commit`, or when a signal ends the program, the temporary file is removed. An existing target
/// keeps its permissions, and a link stays a link. A target that is not a regular file (a pipe,
/// /dev/null) is written directly. The constructor throws InputError when the target cannot be
/// written, so that a command fails before it works for a minute.
class OutputFile {
 public:
  explicit OutputFile(std::string path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::string_view bytes);
  void commit();

 private:
  /// Throws, with the reason from errno.
  [[noreturn]] void fail(const std::string& what) const;

  std::string path_;
  std::filesystem::path target_;
  PartFile part_;  // unset when the target itself is written
  int descriptor_ = -1;
};

}  // namespace detent::cli
