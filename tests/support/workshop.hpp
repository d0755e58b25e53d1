// SPDX-License-Identifier: MIT
#pragma once

#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <utility>

namespace detent::test {

inline std::string content_of(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// A temporary directory, deleted at the end of the test, in which a program runs.
class Workshop {
 public:
  explicit Workshop(std::string program)
      : program_(std::move(program)),
        path_(std::filesystem::temp_directory_path() /
              ("detent-" + std::to_string(std::random_device()()))) {
    std::filesystem::create_directories(path_ / "work");
  }
  ~Workshop() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;

  void write(const std::string& name, const std::string& content) const {
    std::ofstream(path_ / "work" / name, std::ios::binary) << content;
  }

  [[nodiscard]] std::filesystem::path path(const std::string& name = "") const {
    return path_ / "work" / name;
  }

  struct Result {
    int code;
    std::string out;
    std::string err;
  };

  /// Runs the program inside the directory.
  [[nodiscard]] Result run(const std::string& arguments) const {
    return run_script("\"$DETENT\" " + arguments);
  }

  /// Runs a shell script inside the directory; $DETENT is the program.
  [[nodiscard]] Result run_script(const std::string& script) const {
    const std::filesystem::path out = path_ / "out";
    const std::filesystem::path err = path_ / "err";
    const std::string command = "DETENT='" + program_ + "'; cd '" + (path_ / "work").string() +
                                "' && { " + script + "\n} >'" + out.string() + "' 2>'" +
                                err.string() + "'";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content_of(out), content_of(err)};
  }

  [[nodiscard]] std::size_t file_count() const {
    return static_cast<std::size_t>(
        std::distance(std::filesystem::directory_iterator(path_ / "work"), {}));
  }

 private:
  std::string program_;
  std::filesystem::path path_;
};

/// Exit code 2, exactly one line on standard error with this start, nothing on standard output.
inline bool is_one_line_of_error(const Workshop::Result& result, const std::string& start) {
  return result.code == 2 && result.out.empty() && result.err.starts_with(start) &&
         result.err.find("; ") != std::string::npos &&
         std::count(result.err.begin(), result.err.end(), '\n') == 1 && result.err.back() == '\n';
}

}  // namespace detent::test
