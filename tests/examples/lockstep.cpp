// SPDX-License-Identifier: MIT
// A game for two over a network that loses every fifth packet. Each plays on with a prediction of
// the other's keys, and both end with the same world.
#include <deque>
#include <vector>

#include <detent/lockstep/lockstep.hpp>
#include <detent/scene/scene.hpp>
using namespace detent;

using Vec3 = Vec<q16_16, 3>;

/// The state that both simulate. `for_each_field` lists what a digest covers.
struct Game {
  BoundedScene<Bounded<8, 2>, q16_16, 3, Sphere> arena;
  int bumps = 0;
};
template <class F>
void for_each_field(const Game& game, const F& f) {
  f("arena", game.arena);
  f("bumps", game.bumps);
}
/// A player's input, and its encoding in packets.
struct Pad {
  std::int8_t x = 0, z = 0;
};
template <>
struct detent::InputCodec<Pad> : detent::FieldCodec<&Pad::x, &Pad::z> {};

using Match = Session<Game, Pad>;

void simulate(Game& game, const Match::Inputs& pads) {
  constexpr std::array players{ObjectId{0, 1}, ObjectId{1, 2}};
  for (std::size_t i = 0; i < pads.size(); ++i) {
    game.arena.move(players[i], Vec3{q16_16(pads[i].x), {}, q16_16(pads[i].z)});
  }
  std::array<Overlap, 2> bumps;
  if (game.arena.overlaps(bumps) > 0) ++game.bumps;
}

struct Packet {
  std::size_t to;
  std::vector<std::byte> bytes;
};

int main() {
  Game game;
  game.arena.add(Sphere{Vec3{}, q16_16(1)});
  game.arena.add(Sphere{Vec3{q16_16(8), {}, {}}, q16_16(1)});
  static std::array sessions{Match({.match = 4711, .self = 0}, game),
                             Match({.match = 4711, .self = 1}, game)};
  std::deque<Packet> wire;  // packets take four frames
  std::uint32_t count = 0;
  for (int tick = 0; tick < 600; ++tick) {
    const auto now = static_cast<std::uint64_t>(tick) * 16'667;  // microseconds
    for (; wire.size() > 8; wire.pop_front()) {
      sessions[wire.front().to].receive(1 - wire.front().to, wire.front().bytes, now);
    }
    for (std::size_t i = 0; i < 2; ++i) {
      const Pad pad{static_cast<std::int8_t>(tick / (10 + 3 * static_cast<int>(i)) % 3 - 1), 0};
      sessions[i].advance(pad, simulate);
      sessions[i].poll(now, [&](std::size_t to, std::span<const std::byte> bytes) {
        if (++count % 5 != 0) wire.push_back({to, {bytes.begin(), bytes.end()}});
      });
      while (const auto event = sessions[i].next_event()) {
        if (event->kind == SessionEvent::Kind::desync) return 1;
      }
    }
  }
  // Both know that all results except those of the last frames are equal.
  const bool is_long = sessions[0].matched_frame(1) > 550 && sessions[1].matched_frame(0) > 550;
  return is_long && sessions[0].resimulated() > 0 ? 0 : 2;
}
