// SPDX-License-Identifier: MIT
//
// The cost of a rollback in a large match, for bench.mjs: 200 bodies in 2D, twenty of them balls
// that hit twenty walls of nine blocks. Each frame goes back by eight frames and plays nine, as a
// session does after a wrong prediction eight frames ago, with a copy of the world for each and a
// digest of the newly final one.
#include <cstddef>
#include <cstdint>
#include <new>

#include <detent/dynamics/dynamics.hpp>
#include <detent/number/literals.hpp>
#include <detent/scene/world.hpp>

namespace {

using namespace detent::literals;
using S = detent::q16_16;
using World = detent::BoundedWorld<detent::Bounded<201, 1024>, S, 2, detent::Sphere, detent::Obb>;

constexpr std::size_t again = 8;
constexpr std::size_t kept = again + 2;
// The world before frame i is at i modulo `kept`. A module without a start function runs no
// constructors, so `start` makes them.
alignas(World) std::byte storage[kept * sizeof(World)];
std::uint32_t done = 0;
std::uint64_t chain = 0;

World& world_before(std::uint32_t frame) {
  return *std::launder(reinterpret_cast<World*>(storage + frame % kept * sizeof(World)));
}

void build(World& world) {
  detent::BodyOptions<S, 2> rock, block, ball;
  rock.motion = detent::BodyMotion::fixed;
  block.friction = 0.7_q16_16;
  ball.density = 5_q16_16;
  world.add(detent::Obb<S, 2>{{100_q16_16, -1_q16_16}, {150_q16_16, 1_q16_16}, {}}, rock);
  for (int wall = 0; wall < 20; ++wall) {
    for (int i = 0; i < 9; ++i) {
      const detent::Vec<S, 2> center{S(10 * wall + i % 3),
                                     detent::saturate_to<S>(i / 3 + 0.5_q16_16)};
      world.add(detent::Obb<S, 2>{center, {0.5_q16_16, 0.5_q16_16}, {}}, block);
    }
    ball.velocity = {12_q16_16, S(wall % 4)};
    world.add(detent::Sphere<S, 2>{{S(10 * wall - 4), 2_q16_16}, 0.45_q16_16}, ball);
  }
}

void step_once() {
  World& next = world_before(done + 1);
  next = world_before(done++);
  next.step();
}

}  // namespace

#define EXPORT(name) extern "C" __attribute__((export_name(#name)))

/// Builds the world and plays as many frames as a rollback needs. Returns the number of bodies.
EXPORT(start) std::size_t start() {
  done = 0;
  chain = 0;
  for (std::size_t i = 0; i < kept; ++i) ::new (storage + i * sizeof(World)) World();
  build(world_before(0));
  for (std::size_t i = 0; i < again; ++i) step_once();
  return world_before(done).size() - 1;
}

/// Plays a frame, with or without the rollback.
EXPORT(play) void play(int rolls_back) {
  if (rolls_back != 0) done -= again;
  for (std::size_t i = rolls_back != 0 ? again + 1 : 1; i > 0; --i) step_once();
  detent::Digest digest(chain);
  digest.add(detent::detail::WorldDigest(world_before(done - again)).all());
  chain = digest.value();
}

EXPORT(digest) std::uint64_t digest() { return chain; }
/// The number of bodies that are awake.
EXPORT(awake) int awake() {
  const World& world = world_before(done);
  int count = 0;
  for (std::uint32_t i = 1; i <= 200; ++i) {
    const detent::BodyId id{i, i + 1};  // ids in the order they were added
    count += world.contains(id) && !world.is_asleep(id) ? 1 : 0;
  }
  return count;
}
