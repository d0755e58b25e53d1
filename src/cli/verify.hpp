// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace detent::cli {

struct VerifyOptions {
  bool small = false;
  bool exact = false;  // check every result with exact arithmetic
  bool json = false;
  bool golden = false;   // print src/verify/golden.hpp instead
  bool results = false;  // print the lines of tests/verify/results.txt instead
  bool table = false;    // and then the table too
  std::string only;      // rows whose name starts with this
  std::string dump;      // a file for the results
  int threads = 0;
};

/// Runs `detent verify` (docs/verify.md); returns whether every result was golden. Throws
/// InputError when it cannot.
[[nodiscard]] bool verify(const VerifyOptions& options);

}  // namespace detent::cli
