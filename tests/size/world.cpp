// SPDX-License-Identifier: MIT
//
// Steps a 2D pyramid of ten boxes in static memory, on a microcontroller or here. A `yield` before
// and after the last step is for count_instructions.c. Prints the contacts and the digest of the
// world. Needs the macros SCALAR and SUBSTEPS.

#include "detent/dynamics/world.hpp"

#if defined(__arm__)
#define DETENT_LAP __asm__ volatile("yield" : : : "memory")
#else
#define DETENT_LAP
#endif

namespace {

using namespace detent;
using S = SCALAR;
using Bodies = BoundedWorld<Bounded<16>, S, 2, Obb>;

/// A number in eighths.
constexpr S eighths(int count) noexcept { return quotient_nearest<S>(S(count), S(8)); }

void add_box(Bodies& world, int x, int y, int width, int height,
             const BodyOptions<S, 2>& options = {}) noexcept {
  world.add(Obb<S, 2>{{eighths(x), eighths(y)}, {eighths(width), eighths(height)}, {}}, options);
}

}  // namespace

/// A world and its steps: everything a program of boxes needs in flash.
extern "C" void ask(Bodies& world, int steps) {
  BodyOptions<S, 2> fixed;
  fixed.motion = BodyMotion::fixed;
  add_box(world, 0, -8, 160, 8, fixed);
  for (int level = 0; level < 4; ++level) {
    for (int i = 0; i < 4 - level; ++i) add_box(world, 5 * level + 9 * i, 4 + 8 * level, 4, 4);
  }
  for (int i = 0; i < steps; ++i) world.step();
}

#ifdef SUBSTEPS
#include "detent/dynamics/snapshot.hpp"

namespace {

void put_number(void (*put)(const char*), std::uint64_t x) {
  char text[18] = "0000000000000000 ";
  for (int i = 15; i >= 0; --i, x >>= 4) text[i] = "0123456789abcdef"[x & 15];
  put(text);
}

}  // namespace

extern "C" int detent_verify(void (*put)(const char*)) {
  WorldSettings<S, 2> settings;
  settings.substeps = SUBSTEPS;
  settings.sleep_speed = S(0);
  static Bodies world(settings);
  ask(world, 30);
  DETENT_LAP;
  world.step();
  DETENT_LAP;
  put_number(put, detail::WorldAccess::contacts(world).size());
  put_number(put, digest(world));
  put("\n");
  return 0;
}

#if !defined(__arm__)
#include <cstdio>

int main() {
  return detent_verify([](const char* text) { std::fputs(text, stdout); });
}
#endif
#endif
