// SPDX-License-Identifier: MIT
#include "detent/lockstep/session.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "lockstep/network.hpp"
#include "lockstep/toy.hpp"
#include "support/catch.hpp"

using namespace detent;
using namespace detent::test;

namespace {

using Kind = SessionEvent::Kind;

SessionConfig config_of(std::size_t self, std::uint32_t delay, std::uint32_t prediction) {
  SessionConfig config;
  config.match = 77;
  config.self = self;
  config.delay = delay;
  config.prediction = prediction;
  return config;
}
ToySession session_of(std::size_t self, std::uint32_t delay, std::uint32_t prediction) {
  return ToySession(config_of(self, delay, prediction), Toy{});
}

/// The packet that a session has for a peer, or nothing.
Packet packet_for(ToySession& session, std::size_t peer, Time now) {
  Packet result;
  session.poll(now, [&](std::size_t to, std::span<const std::byte> bytes) {
    if (to == peer) result.assign(bytes.begin(), bytes.end());
  });
  return result;
}
/// Both send, then both receive.
void exchange(ToySession& a, ToySession& b, Time now) {
  const auto to_b = packet_for(a, b.config().self, now), to_a = packet_for(b, a.config().self, now);
  if (!to_b.empty()) REQUIRE(b.receive(a.config().self, to_b, now) == Received::yes);
  if (!to_a.empty()) REQUIRE(a.receive(b.config().self, to_a, now) == Received::yes);
}
std::optional<SessionEvent> next(ToySession& session, Kind kind) {
  while (const auto event = session.next_event()) {
    if (event->kind == kind) return event;
  }
  return std::nullopt;
}
/// Plays until `frames` frames are played or prediction reaches its limit.
void play_to(ToySession& session, std::uint32_t frames, const Pad& pad = {}) {
  for (int i = 0; i < 100 && session.frame() < frames; ++i) session.advance(pad, play);
}
constexpr Time tick = 16'667;

}  // namespace

TEST_CASE("session: config is clamped to the limits") {
  SessionConfig config;
  config.players = 20;
  config.self = 50;
  config.spectators = 9;
  config.delay = 12;
  config.prediction = 99;
  config.frames_per_call = 0;
  const auto right = config.within(toy_limits);
  CHECK(right.players == 8);
  CHECK(right.spectators == 2);
  CHECK(right.self == 9);
  CHECK(right.delay == 8);
  CHECK(right.prediction == 16);
  CHECK(right.frames_per_call == 1);
  config.delay = config.prediction = 0;
  CHECK(config.within(toy_limits).delay == 1);
}

TEST_CASE("session: nobody plays before everybody is there") {
  auto a = session_of(0, 2, 8), b = session_of(1, 2, 8);
  CHECK(a.advance({}, play) == Advanced::connecting);
  CHECK(a.is_awaited(1));
  exchange(a, b, 0);
  CHECK(next(a, Kind::connected)->peer == 1);
  CHECK(a.advance({}, play) == Advanced::yes);
  CHECK(a.frame() == 1);
}

TEST_CASE("session: frames come in order, and again if a packet interrupts one") {
  auto a = session_of(0, 0, 8), b = session_of(1, 0, 8);
  exchange(a, b, 0);
  CHECK_FALSE(b.is_open());
  b.close_frame();  // nothing is open
  int interrupted = 0;
  for (std::uint32_t i = 1; i < 120; ++i) {
    const auto of = [&](std::uint32_t player) {
      return Pad{static_cast<std::int8_t>(i / (3 + player) % 3 - 1), i % 7 == player};
    };
    a.advance(of(0), play);
    bool is_first = true;
    const auto played = b.frame();
    while (const auto inputs = b.open_frame(of(1))) {
      CHECK(b.is_open());
      play(b.opened(), *inputs);
      if (is_first && i % 3 == 0) {
        const auto packet = packet_for(a, 1, i * tick);
        if (!packet.empty()) {
          REQUIRE(b.receive(0, packet, i * tick) == Received::yes);
          CHECK_FALSE(b.is_open());
          b.close_frame();
          ++interrupted;
        }
      }
      is_first = false;
      b.close_frame();
    }
    CHECK((b.advanced() == Advanced::yes) == (b.frame() > played));
    if (i % 4 == 0) exchange(a, b, i * tick);
  }
  CHECK(interrupted > 10);
  CHECK(b.resimulated() > 10);
  CHECK(a.matched_frame(1) > 90);
  CHECK(b.matched_frame(0) > 90);
  CHECK_FALSE(next(a, Kind::desync));
  CHECK_FALSE(next(b, Kind::desync));
}

TEST_CASE("session: an input takes effect `delay` frames later, at the same frame everywhere") {
  for (const std::uint32_t delay : {0u, 1u, 5u, 8u}) {
    auto a = session_of(0, delay, 8), b = session_of(1, 0, 8);
    for (Time now = 0; now < 40 * tick; now += tick) {
      exchange(a, b, now);
      a.advance(Pad{1, false}, play);
      b.advance({}, play);
    }
    CHECK(a.world().position[0] == a.frame() - delay);
    const auto* of_b = b.result(30);
    REQUIRE(of_b != nullptr);
    CHECK(of_b->position[0] == 31 - delay);
    REQUIRE(a.inputs(30));
    CHECK((*a.inputs(30))[0] == Pad{1, false});
    CHECK((*a.inputs(30)).frame() == 30);
    CHECK_FALSE(a.inputs(1000));
  }
}

TEST_CASE("session: without prediction every frame has real inputs and is played once") {
  auto a = session_of(0, 2, 0), b = session_of(1, 2, 0);
  exchange(a, b, 0);
  CHECK(a.advance({1, false}, play) == Advanced::yes);
  CHECK(a.advance({1, false}, play) == Advanced::yes);
  CHECK(a.advance({1, false}, play) == Advanced::starved);
  CHECK(a.is_awaited(1));
  CHECK(a.final_frame() == 2);
  CHECK(b.advance({}, play) == Advanced::yes);
  exchange(a, b, tick);
  CHECK_FALSE(a.is_awaited(1));
  CHECK(a.advance({1, false}, play) == Advanced::yes);
  CHECK(a.resimulated() == 0);
}

TEST_CASE("session: a wrong prediction is resimulated, at most `prediction` frames back") {
  for (const std::uint32_t prediction : {1u, 4u, 16u}) {
    auto a = session_of(0, 0, prediction), b = session_of(1, 0, prediction);
    exchange(a, b, 0);
    play_to(a, 100);
    CHECK(a.frame() == prediction);
    CHECK(a.final_frame() == 0);
    play_to(b, prediction, {5, true});
    exchange(a, b, tick);
    const auto before = a.resimulated();
    std::uint32_t simulated = 0;
    const auto counted = [&](Toy& toy, const auto& inputs) {
      simulate(toy, inputs);
      ++simulated;
    };
    while (a.advance({}, counted) == Advanced::ahead) {
    }
    CHECK(simulated == prediction + 1);
    CHECK(a.resimulated() == before + prediction);
    CHECK(a.final_frame() == prediction);
    CHECK(a.result(prediction - 1)->position[1] == prediction * 1005);
  }
}

TEST_CASE("session: one call simulates at most `frames_per_call` frames") {
  auto config = config_of(0, 0, 12);
  config.frames_per_call = 5;
  ToySession a(config, Toy{});
  auto b = session_of(1, 0, 12);
  exchange(a, b, 0);
  play_to(a, 100);
  REQUIRE(a.frame() == 12);
  play_to(b, 12, {5, false});
  exchange(a, b, tick);
  int simulated = 0;
  const auto counted = [&](Toy& toy, const auto& inputs) {
    simulate(toy, inputs);
    ++simulated;
  };
  CHECK(a.advance({}, counted) == Advanced::catching_up);
  CHECK(simulated == 5);
  CHECK(a.world().frame == 5);
  CHECK(a.advance({}, counted) == Advanced::catching_up);
  CHECK(a.advance({}, counted) == Advanced::yes);
  CHECK(simulated == 13);
  CHECK(a.world().frame == 13);
}

TEST_CASE("session: unacknowledged inputs are sent again in every packet") {
  auto a = session_of(0, 0, 16), b = session_of(1, 0, 16);
  exchange(a, b, 0);
  Packet last;
  std::uint32_t sum = 0;
  for (Time now = tick; now < 12 * tick; now += tick) {
    const auto x = static_cast<std::int16_t>(now / tick);
    if (a.advance({x, false}, play) == Advanced::yes) sum += static_cast<std::uint32_t>(x);
    last = packet_for(a, 1, now);  // all but the last are lost
  }
  CHECK(b.receive(0, last, 13 * tick) == Received::yes);
  play_to(b, a.frame());
  CHECK(sum > 50);
  CHECK(b.world().position[0] == sum);
  CHECK(b.resimulated() == 0);
}

TEST_CASE("session: an input stays as it first arrived, and a second one is reported once") {
  auto a = session_of(0, 0, 8), other_a = session_of(0, 0, 8), b = session_of(1, 0, 8);
  exchange(a, b, 0);
  exchange(other_a, b, tick);
  for (int i = 0; i < 4; ++i) {
    a.advance({1, false}, play);
    other_a.advance({static_cast<std::int16_t>(i == 2 ? 2 : 1), false}, play);
  }
  CHECK(b.receive(0, packet_for(a, 1, 3 * tick), 3 * tick) == Received::yes);
  const auto lie = packet_for(other_a, 1, 3 * tick);
  CHECK(b.receive(0, lie, 3 * tick) == Received::yes);
  CHECK(b.receive(0, lie, 3 * tick) == Received::yes);
  for (int i = 0; i < 4; ++i) b.advance({}, play);
  CHECK(b.world().position[0] == 4);
  const auto event = next(b, Kind::contradiction);
  REQUIRE(event);
  CHECK(event->peer == 0);
  CHECK(event->frame == 2);
  CHECK_FALSE(next(b, Kind::contradiction));
}

TEST_CASE("session: packets of others are not read") {
  auto a = session_of(0, 0, 8), b = session_of(1, 0, 8);
  auto config = config_of(0, 0, 8);
  config.match = 78;
  ToySession stranger(config, Toy{});
  CHECK(b.receive(0, packet_for(stranger, 1, 0), 0) == Received::other_match);
  auto packet = packet_for(a, 1, 0);
  CHECK(b.receive(2, packet, 0) == Received::other_match);
  CHECK(b.receive(1, packet, 0) == Received::other_match);
  CHECK(b.receive(0, {}, 0) == Received::other_match);
  CHECK(b.receive(0, std::vector<std::byte>(5000), 0) == Received::other_match);
  packet.back() ^= std::byte{1};
  CHECK(b.receive(0, packet, 0) == Received::other_match);
  CHECK_FALSE(next(b, Kind::connected));
  // A sealed non-packet, and a packet with inputs that were never sent.
  detail::PacketHeader{0}.seal(packet, 77);
  packet.push_back({});
  detail::PacketHeader{0}.seal(packet, 77);
  CHECK(b.receive(0, packet, 0) == Received::malformed);
  for (int i = 0; i < 3; ++i) exchange(a, b, static_cast<Time>(i + 1) * tick), b.advance({}, play);
  exchange(a, b, 9 * tick);
  auto fresh = session_of(1, 0, 8);
  CHECK(fresh.receive(0, packet_for(a, 1, 10 * tick), 10 * tick) == Received::malformed);
}

TEST_CASE("session: a pause stops both peers and is reported") {
  auto a = session_of(0, 1, 8), b = session_of(1, 1, 8);
  exchange(a, b, 0);
  a.pause(true);
  CHECK(a.advance({}, play) == Advanced::paused);
  exchange(a, b, tick);
  CHECK(next(b, Kind::paused)->peer == 0);
  CHECK(b.advance({}, play) == Advanced::paused);
  CHECK(b.is_awaited(0));
  a.pause(false);
  exchange(a, b, 2 * tick);
  CHECK(next(b, Kind::resumed)->peer == 0);
  CHECK(b.advance({}, play) == Advanced::yes);
}

TEST_CASE("session: a silent peer is reported, heard again, and dropped only by the caller") {
  auto a = session_of(0, 1, 8), b = session_of(1, 1, 8);
  exchange(a, b, 0);
  (void)packet_for(a, 1, 1'999'999);
  CHECK_FALSE(next(a, Kind::silent));
  (void)packet_for(a, 1, 2'000'000);
  CHECK(next(a, Kind::silent)->peer == 1);
  exchange(a, b, 3'000'000);
  CHECK(next(a, Kind::heard_again)->peer == 1);
  CHECK_FALSE(a.is_dropped(1));
  a.drop(1);
  CHECK(a.is_dropped(1));
  CHECK(next(a, Kind::left)->peer == 1);
  CHECK(a.receive(1, packet_for(b, 0, 3'100'000), 3'100'000) == Received::dropped);
  // The other peer gets a notice for each of its packets, and continues alone.
  const auto notice = packet_for(a, 1, 3'200'000);
  CHECK(b.receive(0, notice, 3'200'000) == Received::yes);
  CHECK(next(b, Kind::expelled)->peer == 0);
  CHECK(b.is_dropped(0));
  CHECK(packet_for(a, 1, 3'300'000).empty());
  for (int i = 0; i < 50; ++i) CHECK(a.advance({1, false}, play) == Advanced::yes);
  CHECK(a.final_frame() == 50);
  CHECK(a.world().absent[1] == 49);
}

TEST_CASE("session: a peer that never comes is also silent, and the others can start without it") {
  auto a = session_of(0, 1, 8);
  (void)packet_for(a, 1, 500);
  (void)packet_for(a, 1, 2'000'500);
  CHECK(next(a, Kind::silent)->peer == 1);
  a.drop(1);
  CHECK(a.advance({}, play) == Advanced::yes);
}

TEST_CASE("session: the peer that is ahead waits, at most one frame in eight") {
  auto a = session_of(0, 0, 16), b = session_of(1, 0, 16);
  exchange(a, b, 0);
  for (int i = 0; i < 10; ++i) a.advance({}, play);
  int waited = 0, last_wait = -100;
  for (int i = 0; i < 400; ++i) {
    exchange(a, b, static_cast<Time>(i + 1) * tick);
    if (a.advance({}, play) == Advanced::ahead) {
      ++waited;
      CHECK(i - last_wait >= 8);
      last_wait = i;
    }
    CHECK(b.advance({}, play) == Advanced::yes);
  }
  CHECK(waited >= 8);
  CHECK(waited <= 11);
  CHECK(a.frame() <= b.frame() + 2);
}

TEST_CASE("session: packets of idle players are small") {
  auto a = session_of(0, 2, 8), b = session_of(1, 2, 8);
  std::size_t largest = 0;
  for (Time now = 0; now < 600 * tick; now += tick) {
    const auto to_b = packet_for(a, 1, now), to_a = packet_for(b, 0, now);
    largest = std::max(largest, to_b.size());
    a.receive(1, to_a, now);
    b.receive(0, to_b, now);
    a.advance({3, true}, play);
    b.advance({3, true}, play);
  }
  CHECK(largest <= 36);
}
