// SPDX-License-Identifier: MIT
//
// The scripted match of the bindings, played with the C++ library only: see match.c.

#include <array>
#include <cstdint>
#include <cstdio>

#include "detent/dynamics/dynamics.hpp"
#include "detent/scene/scene.hpp"
#include "detent/scene/snapshot.hpp"

using namespace detent;
using Vec3 = Vec<q16_16, 3>;

namespace {

constexpr int one = 65536, bodies = 12, ticks = 120, rays = 8;

std::uint32_t state = 1;
int draw(int count) {
  state = state * 1664525u + 1013904223u;
  return static_cast<int>((state >> 8) % static_cast<std::uint32_t>(count));
}

std::uint64_t sum = 0;
void mix(std::uint64_t value) { sum = sum * 6364136223846793005u + value; }

q16_16 raw(int value) { return q16_16::from_raw(value); }
Vec3 at(int x, int y, int z) { return {raw(x), raw(y), raw(z)}; }

/// A player's input in a frame; it takes effect two frames later.
struct Pad {
  int speed, which;
};
Pad pressed(int frame, int player) {
  if (frame < 0 || frame >= 80) return {0, 0};
  return {frame / (7 + 4 * player) % 5, frame / 3 % 4};
}

/// The two-player match that the bindings play with sessions, here without one.
void play_for_two() {
  constexpr int frames = 120;
  World<q16_16, 3, Sphere, Aabb, Obb, Capsule> world;
  world.add(Aabb{at(-20 * one, -one, -20 * one), at(20 * one, 0, 20 * one)},
            {.motion = BodyMotion::fixed});
  std::array<BodyId, 4> balls;
  for (int i = 0; i < 4; ++i) {
    balls[static_cast<std::size_t>(i)] =
        *world.add(Sphere{at((2 * i - 3) * one, 2 * one, 0), raw(one / 2)});
  }
  std::array<std::uint64_t, 2> words{};
  for (int frame = 0; frame < frames; ++frame) {
    for (int player = 0; player < 2; ++player) {
      const auto pad = pressed(frame - 2, player);
      words[static_cast<std::size_t>(player)] += static_cast<std::uint64_t>(pad.speed);
      if (pad.speed == 0) continue;
      world.set_velocity(balls[static_cast<std::size_t>(2 * player + pad.which % 2)],
                         at((pad.speed - 2) * one, pad.which * one, 0));
    }
    world.step();
  }
  mix(digest(world));
  for (const auto word : words) mix(word);
}

}  // namespace

int main() {
  World<q16_16, 3, Sphere, Aabb, Obb, Capsule> world;
  Scene<q16_16, 3, Sphere> scene;
  world.add(Aabb{at(-20 * one, -one, -20 * one), at(20 * one, 0, 20 * one)},
            {.motion = BodyMotion::fixed});

  std::array<BodyId, bodies> boxes;
  std::array<ObjectId, bodies> balls;
  for (int i = 0; i < bodies; ++i) {
    const int x = draw(4 * one) - 2 * one, y = (2 + 2 * i) * one, z = draw(4 * one) - 2 * one;
    const int a = one / 2 + draw(one / 2), b = one / 2 + draw(one / 2), c = one / 2 + draw(one / 2);
    const auto k = static_cast<std::size_t>(i);
    boxes[k] = *world.add(Obb{at(x, y, z), at(a, b, c), Rotation<q16_16, 3>()});
    balls[k] = *scene.add(Sphere{at(x, y, z), raw(one)}, {.user = k});
  }

  std::vector<std::byte> saved;
  for (int tick = 0; tick < ticks; ++tick) {
    if (tick % 10 == 5) {
      world.set_velocity(boxes[static_cast<std::size_t>(tick / 10)], at(one, 5 * one, 0));
    }
    world.step();
    for (std::size_t i = 0; i < bodies; ++i) {
      scene.replace(balls[i], Sphere{world.position(boxes[i]), raw(one)});
    }
    for (int i = 0; i < rays; ++i) {
      const int x = draw(8 * one) - 4 * one, z = draw(8 * one) - 4 * one;
      const Ray ray{at(x, 30 * one, z), -Direction<q16_16, 3>::along(1), raw(40 * one)};
      if (const auto hit = scene.nearest_hit(ray)) {
        mix(static_cast<std::uint32_t>(hit->distance.raw()));
        mix(hit->id.index);
        mix(static_cast<std::uint32_t>(hit->normal[1].raw()));
      } else {
        mix(0xffffffffu);
      }
    }
    mix(digest(world));
    mix(digest(scene));
    if (tick == ticks / 2) {
      saved = snapshot(world);
      mix(saved.size());
    }
  }

  if (restore(world, saved) != Restored::yes) return 1;
  for (int tick = 0; tick < 10; ++tick) world.step();
  mix(digest(world));
  play_for_two();
  std::printf("%016llx\n", static_cast<unsigned long long>(sum));
}
