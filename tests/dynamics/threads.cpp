// SPDX-License-Identifier: MIT
//
// usage: threads [--plant]
// Steps a world on four threads, which must give the bits of one. Built with the thread sanitizer,
// which reports any unsynchronised access. With --plant each call is made twice, so that two
// threads write to the same elements, which must be reported.

#include "detent/dynamics/threads.hpp"

#include <cstdio>
#include <cstring>

#include "detent/dynamics/snapshot.hpp"
#include "dynamics/stage.hpp"
#include "support/pool.hpp"

int main(int count, char** arguments) {
  using namespace detent;
  using test::at;
  const bool plants = count > 1 && std::strcmp(arguments[1], "--plant") == 0;
  World<q16_16, 2, Sphere, BodyCompound> world;
  test::add_round_ground(world);
  const std::array parts{BodyPart(Sphere<q16_16, 2>{at<q16_16, 2>(0, 0), q16_16(1)}),
                         BodyPart(Sphere<q16_16, 2>{at<q16_16, 2>(1, 0), q16_16(1)})};
  const auto solid = solid_compound(1, parts).value();
  for (int i = 0; i < 150; ++i) {
    const double x = 1.7 * (i % 30) - 25, y = 0.5 + 1.7 * static_cast<double>(i / 30);
    if (i % 10 == 0) {
      world.add(BodyCompound<q16_16, 2>{&solid, at<q16_16, 2>(x, y), {}});
    } else {
      test::add_ball(world, x, y);
    }
  }
  auto other = world;
  test::Pool pool(4);
  const auto twice = [&](std::size_t calls, const auto& f) {
    pool(2 * calls, [&](std::size_t i) { f(i / 2); });
  };
  for (int tick = 0; tick < 5; ++tick) {
    if (plants) {
      other.step(twice);
      continue;
    }
    world.step();
    other.step(pool);
    if (digest(world) == digest(other)) continue;
    std::puts("threads got other bits");
    return 1;
  }
  return 0;
}
