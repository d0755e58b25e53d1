// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace detent::cli {

/// The name of a file that disappears with this object, and when a signal ends the program.
class PartFile {
 public:
  PartFile() = default;
  ~PartFile();
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;

  /// Takes charge of a file, which need not be there yet.
  void own(const std::string& path);
  /// Leaves the file, if there is one, to whoever has it now.
  void release();

  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
  int slot_ = -1;
};

}  // namespace detent::cli
