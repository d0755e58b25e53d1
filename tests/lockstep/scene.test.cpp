// SPDX-License-Identifier: MIT
//
// A world with a scene: a desync names its object.
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "detent/lockstep/session.hpp"
#include "detent/scene/scene.hpp"
#include "support/catch.hpp"

using namespace detent;
using S = q16_16;

namespace {

struct Game {
  BoundedScene<Bounded<8, 2>, S, 3, Sphere> arena;
  std::array<std::int32_t, 2> score{};
};
template <class F>
void for_each_field(const Game& game, const F& f) {
  f("arena", game.arena);
  f("score", game.score);
}
constexpr SessionLimits limits{.players = 2, .peers = 2, .prediction = 8, .evidence = 16};
using Match = Session<Game, std::int8_t, limits>;
constexpr std::array players{ObjectId{0, 1}, ObjectId{1, 2}};

void simulate(Game& game, const Match::Inputs& inputs) {
  for (std::size_t i = 0; i < 2; ++i) {
    game.arena.move(players[i], Vec<S, 3>{S(inputs[i]), {}, S(1)});
    game.score[i] += inputs[i];
  }
}

}  // namespace

TEST_CASE("scene: an object moved by one peer is named at both, by frame, object and field") {
  Game game;
  game.arena.add(Sphere<S, 3>{{}, S(1)});
  game.arena.add(Sphere<S, 3>{{S(9), {}, {}}, S(1)});
  SessionConfig config;
  std::array<std::unique_ptr<Match>, 2> peers;
  for (std::size_t i = 0; i < 2; ++i) {
    config.self = i;
    peers[i] = std::make_unique<Match>(config, game);
  }
  std::array<std::optional<SessionEvent>, 2> desync, field;
  std::array<std::vector<std::byte>, 2> wire;  // to each
  for (std::uint64_t tick = 0; tick < 120; ++tick) {
    const auto now = tick * 16'667;
    for (std::size_t i = 0; i < 2; ++i) {
      if (!wire[i].empty()) peers[i]->receive(1 - i, wire[i], now);
    }
    for (std::size_t i = 0; i < 2; ++i) {
      const auto input = static_cast<std::int8_t>(static_cast<int>(tick / (4 + i) % 3) - 1);
      peers[i]->advance(input, [&](Game& world, const Match::Inputs& inputs) {
        simulate(world, inputs);
        if (i == 1 && inputs.frame() == 40) world.arena.move(players[1], {{}, S(1), {}});
      });
      peers[i]->poll(now, [&](std::size_t to, std::span<const std::byte> bytes) {
        wire[to].assign(bytes.begin(), bytes.end());
      });
      while (const auto event = peers[i]->next_event()) {
        if (event->kind == SessionEvent::Kind::desync) desync[i] = event;
        if (event->kind == SessionEvent::Kind::desync_field) field[i] = event;
      }
    }
  }
  for (std::size_t i = 0; i < 2; ++i) {
    REQUIRE(desync[i]);
    CHECK(desync[i]->frame == 40);
    REQUIRE(field[i]);
    CHECK(field[i]->frame == 40);
    CHECK(field[i]->object == players[1]);
    CHECK(std::string(field[i]->field.view()) == "arena object 1:2 (sphere) center.y");
  }
}
