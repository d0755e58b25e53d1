// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace detent::cli {

/// The name of a file that is removed with this object, and when a signal ends the program.
class PartFile {
 public:
  PartFile() = default;
  ~PartFile();
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;

  /// Takes ownership of a file, which need not exist yet.
  void own(const std::string& path);
  /// Gives up ownership and keeps the file, if there is one.
  void release();

  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
  int slot_ = -1;
};

}  // namespace detent::cli
