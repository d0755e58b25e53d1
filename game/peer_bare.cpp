// SPDX-License-Identifier: MIT
//
// Plays the steps of peer.cpp on a machine that can only print; tests/platforms/bare starts it.
#include "steps.hpp"

namespace {

void print_with(void (*put)(const char*), std::uint32_t frames, std::uint64_t digest) {
  const detent::FieldName number = detent::FieldName().add_number(frames);
  char text[18] = {};
  for (int i = 0; i < 16; ++i) text[i] = "0123456789abcdef"[(digest >> (60 - 4 * i)) & 15];
  text[16] = '\n';
  put(number.c_str());
  put(" ");
  put(text);
}

}  // namespace

extern "C" int detent_verify(void (*put)(const char*)) {
  static slingshot::Match match(slingshot::golden_seed);  // 340 KB is too much for the stack
  slingshot::play_steps(match, 3000, [put](std::uint32_t frames, std::uint64_t digest) {
    print_with(put, frames, digest);
  });
  return 0;
}
