// SPDX-License-Identifier: MIT
//
// Prints the digest of the corpus. From the repository, with any C++20 compiler and flags:
//
//     g++ -std=c++20 -O2 -Iinclude -Itests tests/platforms/digest.cpp -o digest && ./digest
//
// and compare with tests/golden/corpus.txt.

#include <cinttypes>
#include <cstdio>

#include "platforms/corpus.hpp"

int main() {
  const auto everything =
      detent::platforms::digest_corpus(2000, [](const detent::platforms::Line& line) {
        std::printf("%-8s %-6s %dD %4" PRIu32 " of %4" PRIu32 " hit  %016" PRIx64 "\n",
                    line.subject, line.scalar, line.dimension, line.hits, line.total, line.digest);
      });
  std::printf("everything %016" PRIx64 "\n", everything);
}
