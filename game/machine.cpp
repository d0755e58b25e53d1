// SPDX-License-Identifier: MIT
//
// A part of the corpus of `detent verify` for the page: does this machine give the golden answers?
#include <array>
#include <string_view>

#include "verify/check.hpp"

using namespace detent::verify;

namespace {

std::array<char, 1 << 16> text;
std::size_t size = 0;

void put(std::string_view more) {
  for (const char letter : more) {
    if (size < text.size()) text[size++] = letter;
  }
}

/// Lines: name, digest, 1 if it is golden.
void put_line(std::string_view name, std::uint64_t digest, bool is_golden) {
  put(name);
  put(" ");
  for (int i = 60; i >= 0; i -= 4)
    put(std::string_view(&"0123456789abcdef"[(digest >> i) & 15], 1));
  put(is_golden ? " 1\n" : " 0\n");
}

template <class Part>
void run() {
  static_cast<void>(check<Part, Whole>(small_size, golden::small, [](const RowResult& row) {
    put_line(row.name, row.digest, row.is_golden);
  }));
}

}  // namespace

#define EXPORT(name) extern "C" __attribute__((export_name(#name)))

EXPORT(text_at) const char* text_at() { return text.data(); }

/// Runs the part with this number; returns how many letters its lines have, or -1 if there is none.
EXPORT(run_part) int run_part(int number) {
  size = 0;
  if (number == 0) {
    run<Arithmetic>();
  } else if (number == 1) {
    run<Turns>();
  } else if (number == 2) {
    run<SolidRays>();
  } else if (number == 3) {
    run<RoundPoints>();
  } else {
    return -1;
  }
  return static_cast<int>(size);
}
