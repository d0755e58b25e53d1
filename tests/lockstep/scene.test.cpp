// SPDX-License-Identifier: MIT
//
// A world with a scene: a desync names its object.
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "detent/scene/scene.hpp"
#include "lockstep/two_peers.hpp"
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
  const auto found =
      test::play<Match>({}, game, [](std::size_t peer, Game& world, const Match::Inputs& inputs) {
        simulate(world, inputs);
        if (peer == 1 && inputs.frame() == 40) world.arena.move(players[1], {{}, S(1), {}});
      });
  for (std::size_t i = 0; i < 2; ++i) {
    REQUIRE(found.desync[i]);
    CHECK(found.desync[i]->frame == 40);
    REQUIRE(found.field[i]);
    CHECK(found.field[i]->frame == 40);
    CHECK(found.field[i]->object == players[1]);
    CHECK(std::string(found.field[i]->field.view()) == "arena object 1:2 (sphere) center.y");
  }
}
