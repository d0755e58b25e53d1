// SPDX-License-Identifier: MIT
//
// When players leave, all remaining players use the same inputs.
#include <algorithm>

#include "lockstep/match.hpp"
#include "support/catch.hpp"

using namespace detent;
using namespace detent::test;

namespace {

using Kind = SessionEvent::Kind;

bool is_offline(const Match& match, std::size_t i) {
  const MatchPeer& peer = *match.peers[i];
  const auto offline = match.offline(i, peer.session.checked_frame());
  for (std::size_t frame = 0; frame < offline.size(); ++frame) {
    if (peer.chain[frame] != 0 && peer.chain[frame] != offline[frame]) return false;
  }
  return true;
}

std::vector<SessionConfig> four(std::uint32_t delay = 2) {
  SessionConfig config;
  config.players = 4;
  config.delay = delay;
  config.silence = 700'000;
  return std::vector<SessionConfig>(4, config);
}

}  // namespace

TEST_CASE("drop-out: remaining peers agree on the last input, even if only one received it") {
  // Player 3 vanishes while its last packets reach only player 1.
  HitRate others_had_fewer;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    INFO("seed " << seed);
    Match match(seed, {40'000, 30'000, 100, 0}, four(4));
    const Time vanishes = 900'000 + 1000 * seed;
    match.network.is_cut = [&](std::size_t from, std::size_t to, Time now) {
      return (from == 3 && to != 1 && now >= vanishes) || (from == 3 && now >= vanishes + 60'000) ||
             (to == 3 && now >= vanishes);
    };
    std::array<std::uint32_t, 4> held{};
    match.on_event = [&](std::size_t peer, const SessionEvent& event) {
      if (event.kind == Kind::dropped && event.peer == 3) {
        held[peer] = match.peers[peer]->session.final_frame();
      }
    };
    const bool is_done = match.run_until(200, 60'000'000);
    REQUIRE(is_done);
    const auto& end = match.peers[1]->ends[3];
    REQUIRE(end);
    for (const std::size_t i : {0u, 1u, 2u}) {
      CHECK(match.peers[i]->ends[3] == end);
      CHECK(is_offline(match, i));
      CHECK_FALSE(match.peers[i]->session.is_dropped((i + 1) % 3));
    }
    others_had_fewer.count(held[0] + 1 < *end);
  }
  CHECK(others_had_fewer.percent() >= 30);
}

TEST_CASE("drop-out: anybody can drop a player who is still playing") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    INFO("seed " << seed);
    auto configs = four(static_cast<std::uint32_t>(seed % 7));
    for (auto& config : configs) config.prediction = 12;
    Match match(seed, {20'000, 50'000, 150, 0}, configs);
    while (match.now() < 1'200'000 + 3000 * seed) match.tick();
    match.peers[seed % 3]->session.drop(3);
    REQUIRE(match.run_until(200, 60'000'000));
    for (std::size_t i = 0; i < 4; ++i) CHECK(is_offline(match, i));
    INFO(story(match));
    CHECK(match.peers[0]->ends[3] == match.peers[1]->ends[3]);
    CHECK(match.peers[0]->ends[3] == match.peers[2]->ends[3]);
    CHECK(match.peers[0]->ends[3]);
    // The dropped player continues alone.
    for (std::size_t i = 0; i < 3; ++i) CHECK(match.peers[3]->ends[i]);
  }
}

TEST_CASE("drop-out: a peer that helps to agree can vanish as well") {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    INFO("seed " << seed);
    Match match(seed, {30'000, 40'000, 200, 50}, four(3));
    Random random(seed);
    const Time first = 800'000, second = 1'450'000 + random.below(300'000);
    match.network.is_cut = [&](std::size_t from, std::size_t to, Time now) {
      const auto is_out = [&](std::size_t i) {
        return (i == 3 && now >= first) || (i == 2 && now >= second);
      };
      return is_out(from) || is_out(to);
    };
    REQUIRE(match.run_until(200, 60'000'000));
    CHECK(match.peers[0]->ends[3] == match.peers[1]->ends[3]);
    CHECK(match.peers[0]->ends[2] == match.peers[1]->ends[2]);
    CHECK((match.peers[0]->ends[2] && match.peers[0]->ends[3]));
    for (std::size_t i = 0; i < 4; ++i) CHECK(is_offline(match, i));
  }
}

TEST_CASE("drop-out: both halves of a partition continue, each in agreement") {
  Match match(8, {20'000, 5'000, 50, 0}, four());
  match.network.is_cut = [](std::size_t from, std::size_t to, Time now) {
    return from / 2 != to / 2 && now >= 1'000'000;
  };
  REQUIRE(match.run_until(250, 60'000'000));
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(is_offline(match, i));
    const std::size_t mate = i ^ 1u;
    for (std::size_t k = 0; k < 4; ++k) {
      CHECK(match.peers[i]->ends[k].has_value() == (k / 2 != i / 2));
      CHECK(match.peers[i]->ends[k] == match.peers[mate]->ends[k]);
    }
  }
}

TEST_CASE("drop-out: a partition shorter than the silence drops nobody") {
  Match match(9, {20'000, 5'000, 50, 0}, four());
  match.network.is_cut = [](std::size_t from, std::size_t to, Time now) {
    return from / 2 != to / 2 && now >= 1'000'000 && now < 1'600'000;
  };
  REQUIRE(match.run_until(250, 60'000'000));
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(is_offline(match, i));
    CHECK(match.peers[i]->starved > 0);
    for (const auto& event : match.peers[i]->events) CHECK(event.kind != Kind::dropped);
  }
}

TEST_CASE("drop-out: a spectator sees the agreed match, and one that falls behind harms nobody") {
  auto configs = four();
  configs.push_back(configs[0]);
  for (auto& config : configs) config.spectators = 1;
  Match match(10, {30'000, 20'000, 100, 0}, configs);
  match.awaits_spectators = true;
  match.network.is_cut = [](std::size_t from, std::size_t to, Time now) {
    return (from == 1 || to == 1) && now >= 900'000;
  };
  REQUIRE(match.run_until(200, 60'000'000));
  CHECK(match.peers[4]->ends[1] == match.peers[0]->ends[1]);
  for (std::size_t i = 0; i < 5; ++i) CHECK(is_offline(match, i));

  Match slow(11, {30'000, 20'000, 100, 0}, configs);
  slow.awaits_spectators = false;
  slow.drops_silent = false;
  slow.network.is_cut = [](std::size_t from, std::size_t to, Time now) {
    return (from == 4 || to == 4) && now >= 900'000;
  };
  REQUIRE(slow.run_until(400, 60'000'000));
  CHECK(is_offline(slow, 4));
  CHECK(std::any_of(slow.peers[0]->events.begin(), slow.peers[0]->events.end(),
                    [](const auto& event) { return event.kind == Kind::too_slow; }));
}
