// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace detent::cli {

struct VerifyOptions {
  bool small = false;
  bool exact = false;  // ask exact arithmetic about every answer
  bool json = false;
  bool golden = false;   // print src/verify/golden.hpp instead
  bool results = false;  // print the lines of tests/verify/results.txt instead
  std::string only;      // rows whose name begins so
  std::string dump;      // a file for the answers
  int threads = 0;
};

/// Does what `detent verify` says (docs/verify.md); whether every answer was the golden one.
/// Throws InputError when it cannot.
[[nodiscard]] bool verify(const VerifyOptions& options);

}  // namespace detent::cli
