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
  detent::platforms::digest_corpus(1000, [](const detent::platforms::Line& line) {
    std::printf("%-10s %-7s %d  %4" PRIu32 " / %4" PRIu32 "  %016" PRIx64 "\n", line.subject,
                line.scalar, line.dimension, line.hits, line.total, line.digest);
  });
}
