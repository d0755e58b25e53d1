// SPDX-License-Identifier: MIT
//
// A session with a world of bodies: a desync names the body.
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "detent/dynamics/dynamics.hpp"
#include "lockstep/two_peers.hpp"
#include "support/catch.hpp"

using namespace detent;
using S = q16_16;

namespace {

using Bodies = BoundedWorld<Bounded<8>, S, 2, Sphere>;
constexpr SessionLimits limits{.players = 2, .peers = 2, .prediction = 8, .evidence = 16};
using Match = Session<Bodies, std::int8_t, limits>;

/// A fixed ball, and one for each player to push around on it.
Bodies start() {
  Bodies world;
  BodyOptions<S, 2> fixed;
  fixed.motion = BodyMotion::fixed;
  world.add(Sphere<S, 2>{{{}, S(-50)}, S(50)}, fixed);
  for (int i = 0; i < 2; ++i) world.add(Sphere<S, 2>{{S(3 * i), S(1)}, S(1)});
  return world;
}
constexpr std::array players{BodyId{1, 2}, BodyId{2, 3}};

void simulate(Bodies& world, const Match::Inputs& inputs) {
  for (std::size_t i = 0; i < 2; ++i) {
    if (inputs[i] != 0) world.set_velocity(players[i], {S(inputs[i]), {}});
  }
  world.step();
}

/// Plays 120 ticks; meddle(peer, world, frame) is called after each frame.
template <class Meddle>
test::TwoPeers<Match> play(const Meddle& meddle) {
  SessionConfig config;
  config.delay = 0;
  auto found = test::play<Match>(config, start(),
                                 [&](std::size_t peer, Bodies& world, const Match::Inputs& inputs) {
                                   simulate(world, inputs);
                                   meddle(peer, world, inputs.frame());
                                 });
  CHECK(found.peers[0]->final_frame() > 100);
  CHECK(found.peers[0]->resimulated() > 0);
  return found;
}

}  // namespace

TEST_CASE("world: two peers play a world of bodies in step, with rollbacks") {
  const auto found = play([](std::size_t, Bodies&, std::uint32_t) {});
  CHECK_FALSE(found.desync[0]);
  CHECK_FALSE(found.desync[1]);
}

TEST_CASE("world: a body pushed by one peer is named at both, by frame, body and field") {
  const auto found = play([](std::size_t peer, Bodies& world, std::uint32_t frame) {
    if (peer == 1 && frame == 40) world.set_angular_velocity(players[0], {S(1)});
  });
  for (std::size_t i = 0; i < 2; ++i) {
    REQUIRE(found.desync[i]);
    CHECK(found.desync[i]->frame == 40);
    REQUIRE(found.field[i]);
    CHECK(found.field[i]->frame == 40);
    CHECK(found.field[i]->object == players[0]);
    CHECK(std::string(found.field[i]->field.view()) == "body 1:2 (sphere) spin[0]");
  }
}

TEST_CASE("world: a fixed body moved by one peer is named as well") {
  const auto found = play([](std::size_t peer, Bodies& world, std::uint32_t frame) {
    if (peer == 0 && frame == 50) {
      detail::WorldAccess::bodies(world)[0].user = 1;
    }
  });
  for (std::size_t i = 0; i < 2; ++i) {
    REQUIRE(found.field[i]);
    CHECK(found.field[i]->frame == 50);
    CHECK(std::string(found.field[i]->field.view()) == "body 0:1 (sphere) user");
  }
}
