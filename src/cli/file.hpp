// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace detent::cli {

/// The bytes of a file; throws InputError when it is missing, a directory or unreadable.
[[nodiscard]] std::string read_file(const std::string& path);

/// A file that appears whole or not at all.
///
/// It is written under a temporary name beside the target and renamed by `commit`; without that the
/// temporary file is removed. A target that is no regular file (a pipe, /dev/null) is written to
/// directly. The constructor throws InputError when the place cannot be written, so that a command
/// can find out before it works for a minute.
class OutputFile {
 public:
  explicit OutputFile(std::string path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::string_view bytes);
  void commit();

 private:
  [[noreturn]] void fail(std::string_view reason) const;

  std::string path_;
  std::filesystem::path target_;
  std::filesystem::path written_;  // the temporary file, or the target itself
  std::ofstream stream_;
};

}  // namespace detent::cli
