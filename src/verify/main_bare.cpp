// SPDX-License-Identifier: MIT
//
// `detent verify` for a machine that can only print: no operating system, heap, floating point or
// 64-bit word. Call
//
//     int status = detent_verify(put);
//
// where `put` prints a 0-terminated text. The status is 0 when every digest is golden and 1
// otherwise. With a hosted compiler this file is a program that does that:
//
//     g++ -std=c++20 -O2 -Iinclude -Isrc src/verify/main_bare.cpp -o verify && ./verify
//
// DETENT_VERIFY_PART=SolidRays (or another part or volume of corpus.hpp) runs only that, if a
// compiler or machine has little memory.
// DETENT_VERIFY_QUARTER=0 (to 3) runs every query in only one of the four scalars, which compiles
// in a quarter of the time; the other quarters run the rest.
// DETENT_VERIFY_SMALL runs a microcontroller's share of the questions (seconds at 48 MHz).
// DETENT_VERIFY_NO_MAIN leaves out `main`, for a hosted program that has its own.

#include "verify/check.hpp"

#ifndef DETENT_VERIFY_PART
#define DETENT_VERIFY_PART Corpus
#endif

namespace {

#ifdef DETENT_VERIFY_QUARTER
using Share = detent::verify::Quarter<DETENT_VERIFY_QUARTER>;
#else
using Share = detent::verify::Whole;
#endif

using Put = void (*)(const char*);

void put_name(Put put, std::string_view name) {
  char letter[2] = {};
  for (const char c : name) {
    letter[0] = c;
    put(letter);
  }
}

void put_digest(Put put, std::uint64_t digest) {
  char text[17] = {};
  for (int i = 0; i < 16; ++i) text[i] = "0123456789abcdef"[(digest >> (60 - 4 * i)) & 15];
  put(text);
}

}  // namespace

extern "C" int detent_verify(void (*put)(const char*)) {
  using namespace detent::verify;
#ifdef DETENT_VERIFY_SMALL
  constexpr auto size = small_size;
  constexpr auto& expected = golden::small;
#else
  constexpr auto size = full_size;
  constexpr auto& expected = golden::full;
#endif
  const auto total = check<DETENT_VERIFY_PART, Share>(size, expected, [put](const RowResult& row) {
    put_name(put, row.name);
    put(" ");
    put_digest(put, row.digest);
    if (row.is_golden) {
      put(" ok\n");
    } else {
      put(" DIFFERENT (");
      put_name(put, row.scalar);
      const char dimension[] = {' ', static_cast<char>('0' + row.dimension), 'D', '\0'};
      put(dimension);
      put(")\n");
    }
  });
  put_name(put, DETENT_VERIFY_PART::name);
  put(" ");
  put_digest(put, total.digest);
  put(total.is_golden ? " ok\n" : " DIFFERENT\n");
  return total.is_golden ? 0 : 1;
}

#if __STDC_HOSTED__ && !defined(DETENT_VERIFY_NO_MAIN)
#include <cstdio>

int main() {
  return detent_verify([](const char* text) { std::fputs(text, stdout); });
}
#endif
