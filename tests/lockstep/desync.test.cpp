// SPDX-License-Identifier: MIT
//
// Planted desyncs are detected and named, with the first frame.
#include "lockstep/match.hpp"

#include <string>

#include "support/catch.hpp"

using namespace detent;
using namespace detent::test;

namespace {

using Kind = SessionEvent::Kind;

std::optional<SessionEvent> event_of(const MatchPeer& peer, Kind kind, std::size_t about) {
  for (const auto& event : peer.events) {
    if (event.kind == kind && event.peer == about) return event;
  }
  return std::nullopt;
}

}  // namespace

TEST_CASE("desync: a bit flipped by one peer is found in its frame and field within a second") {
  Random random(7);
  for (int round = 0; round < 60; ++round) {
    INFO("round " << round);
    SessionConfig config;
    config.players = 2 + random.below(3);
    config.delay = static_cast<std::uint32_t>(random.below(4));
    config.prediction = static_cast<std::uint32_t>(2 + random.below(14));
    const Weather weather{random.below(100'000), random.below(20'000), random.below(150), 50};
    Match match(random.next(), weather, std::vector<SessionConfig>(config.players, config));
    const auto culprit = random.below(config.players);
    const auto frame = static_cast<std::uint32_t>(40 + random.below(60));
    const auto field = random.below(4);
    std::optional<Time> when;
    match.simulate_at = [&](std::size_t peer, Toy& toy, const ToySession::Inputs& inputs) {
      simulate(toy, inputs);
      if (peer != culprit || inputs.frame() != frame) return;
      if (!when) when = match.now();
      switch (field) {
        case 0:
          toy.position[5] ^= 4;
          return;
        case 1:
          toy.absent[0] ^= 1;
          return;
        case 2:
          toy.frame += 2;
          return;
        default:
          toy.mixed ^= 1u << 31;
      }
    };
    REQUIRE(match.run_until(frame + 150, 60'000'000));
    const std::array<std::string, 4> names{"position[5]", "absent[0]", "frame", "mixed"};
    for (std::size_t i = 0; i < config.players; ++i) {
      const auto other = i == culprit ? (i + 1) % config.players : culprit;
      INFO("peer " << i << ", culprit " << culprit);
      const auto desync = event_of(*match.peers[i], Kind::desync, other);
      REQUIRE(desync);
      CHECK(desync->frame == frame);
      const auto named = event_of(*match.peers[i], Kind::desync_field, other);
      REQUIRE(named);
      CHECK(named->frame == frame);
      CHECK(std::string(named->field.view()) == names[field]);
      for (std::size_t k = 0; k < config.players; ++k) {
        if (k == i || i == culprit || k == culprit) continue;
        CHECK_FALSE(event_of(*match.peers[i], Kind::desync, k));
      }
    }
  }
}

TEST_CASE("desync: is reported within a round trip after the frame is final at both peers") {
  for (const Time latency : {0u, 30'000u, 90'000u}) {
    SessionConfig config;
    config.delay = 1;
    config.prediction = 16;
    Match match(3, {latency, 0, 0, 0}, {config, config});
    std::array<Time, 2> reported{};
    Time final_at = 0;
    match.simulate_at = [&](std::size_t peer, Toy& toy, const ToySession::Inputs& inputs) {
      simulate(toy, inputs);
      if (peer == 1 && inputs.frame() == 60) toy.frame ^= 1;
    };
    match.on_event = [&](std::size_t peer, const SessionEvent& event) {
      if (event.kind == Kind::desync) reported[peer] = match.now();
    };
    while (match.now() < 10'000'000 && (reported[0] == 0 || reported[1] == 0)) {
      match.tick();
      if (final_at == 0 && match.peers[0]->session.checked_frame() > 60 &&
          match.peers[1]->session.checked_frame() > 60) {
        final_at = match.now();
      }
    }
    REQUIRE(final_at > 0);
    const Time ticks = 3 * 16'667;  // packets leave and are read in ticks
    CHECK(reported[0] > 0);
    CHECK(reported[1] > 0);
    CHECK(reported[0] <= final_at + 2 * latency + ticks);
    CHECK(reported[1] <= final_at + 2 * latency + ticks);
  }
}

TEST_CASE("desync: different inputs for different peers are named as input") {
  // Three players; what player 0 sends to player 2 comes from a session that presses other keys.
  SessionConfig config;
  config.players = 3;
  config.silence = 100'000'000;
  Match match(5, {20'000, 0, 0, 0}, {config, config, config});
  config.self = 0;
  ToySession liar(config, Toy{});
  std::vector<Packet> lies;
  match.meddle = [&](std::size_t from, std::size_t to, Packet& packet) {
    if (to == 0) liar.receive(from, packet, match.now());
    if (from == 0 && to == 2) {
      liar.advance(Pad{static_cast<std::int16_t>(liar.frame() == 50 ? 9 : 1), false}, play);
      liar.poll(match.now(), [&](std::size_t peer, std::span<const std::byte> bytes) {
        if (peer == 2) packet.assign(bytes.begin(), bytes.end());
      });
    }
  };
  (void)match.run_until(120, 10'000'000);
  const auto desync = event_of(*match.peers[1], Kind::desync, 2);
  REQUIRE(desync);
  const auto named = event_of(*match.peers[1], Kind::desync_field, 2);
  REQUIRE(named);
  CHECK(std::string(named->field.view()).substr(0, 8) == "input[0]");
}
