// SPDX-License-Identifier: MIT
//
// The sample on a machine that can only print; tests/platforms/bare starts it.
#include "microcontroller.hpp"

namespace {

microcontroller::Toy toy;

/// Prints decimals, or 16 hexadecimal digits.
struct Text {
  char characters[24] = {};

  static Text of(std::uint32_t number) {
    Text text;
    int size = 1;
    for (std::uint32_t rest = number; rest >= 10; rest /= 10) ++size;
    for (; size > 0; number /= 10) text.characters[--size] = static_cast<char>('0' + number % 10);
    return text;
  }
  static Text hexadecimal(std::uint64_t word) {
    Text text;
    for (int i = 0; i < 16; ++i)
      text.characters[i] = "0123456789abcdef"[(word >> (60 - 4 * i)) & 15];
    return text;
  }
};

}  // namespace

extern "C" int detent_verify(void (*put)(const char*)) {
  microcontroller::build(toy);
  for (std::uint32_t tick = 0; tick < 240; ++tick) {
    microcontroller::step(toy, tick);
    if ((tick + 1) % 60 != 0) continue;
    put("microcontroller ");
    put(Text::of(tick + 1).characters);
    put(" ");
    put(Text::hexadecimal(detent::digest(toy)).characters);
    put("\n");
  }
  return 0;
}
