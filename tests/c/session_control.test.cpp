// SPDX-License-Identifier: MIT
//
// What a game does with a session of the C interface besides playing: it pauses, resumes and drops
// a peer. Versions and defaults are those of C++.

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "c/convert.hpp"
#include "calls.hpp"
#include "detent/version.hpp"
#include "support/catch.hpp"

namespace {

using detent::c::Types;
using detent::test_c::Calls;

/// Two peers in one context, whose packets arrive in the next tick, or never.
template <int N>
struct Peers {
  using C = Calls<N>;
  struct Packet {
    std::array<std::uint8_t, DETENT_PACKET> bytes;
    std::uint32_t size, to;
  };
  detent_context context{};
  std::array<detent_handle, 2> sessions{}, worlds{};
  std::array<std::uint32_t, 2> states{};
  std::vector<Packet> wire;
  std::uint64_t now = 0;
  bool is_connected = true;

  Peers() {
    REQUIRE(detent_open(&context, nullptr) == DETENT_OK);
    detent_handle start = 0;
    REQUIRE(C::world_create(&context, nullptr, &start) == DETENT_OK);
    typename Types<N>::Shape ball{};
    ball.kind = DETENT_SPHERE;
    ball.as.sphere.radius = 65536;
    detent_id id{};
    REQUIRE(C::world_add(&context, start, &ball, nullptr, &id) == DETENT_OK);
    for (std::uint32_t self = 0; self < 2; ++self) {
      detent_session_settings settings{};
      REQUIRE(detent_session_default_settings(&settings) == DETENT_OK);
      settings.self = self;
      settings.input_size = 1;
      REQUIRE(C::session_create(&context, &settings, start, &sessions[self]) == DETENT_OK);
      REQUIRE(C::session_world(&context, sessions[self], &worlds[self]) == DETENT_OK);
    }
  }
  Peers(const Peers&) = delete;
  Peers& operator=(const Peers&) = delete;
  ~Peers() { detent_close(&context); }

  void tick() {
    auto came = std::move(wire);
    wire.clear();
    for (const auto& one : came) {
      if (!is_connected) break;
      REQUIRE(C::session_receive(&context, sessions[one.to], 1 - one.to, one.bytes.data(), one.size,
                                 now) == DETENT_OK);
    }
    for (std::uint32_t self = 0; self < 2; ++self) {
      const auto input = static_cast<std::uint8_t>(self);
      std::array<std::uint8_t, 2> inputs{};
      detent_frame frame{};
      while (C::session_begin_frame(&context, sessions[self], &input, &frame, inputs.data()) ==
             DETENT_OK) {
        REQUIRE(C::world_step(&context, worlds[self]) == DETENT_OK);
        REQUIRE(C::session_end_frame(&context, sessions[self]) == DETENT_OK);
      }
      states[self] = frame.state;
      Packet packet{};
      while (C::session_packet(&context, sessions[self], now, &packet.to, packet.bytes.data(),
                               DETENT_PACKET, &packet.size) == DETENT_OK) {
        wire.push_back(packet);
      }
    }
    now += 16667;
  }
  void ticks(int count) {
    for (int i = 0; i < count; ++i) tick();
  }
  [[nodiscard]] std::uint32_t frame(std::uint32_t self) const {
    detent_session_status status{};
    REQUIRE(C::session_status(&context, sessions[self], &status) == DETENT_OK);
    return status.frame;
  }
  /// Whether this event is among those that happened since.
  bool happened(std::uint32_t self, std::uint32_t kind) {
    bool is_there = false;
    detent_session_event event{};
    while (C::session_event(&context, sessions[self], &event, nullptr, 0) == DETENT_OK) {
      is_there = is_there || event.kind == kind;
    }
    return is_there;
  }
};

template <int N>
void check_control() {
  using C = Calls<N>;
  Peers<N> peers;
  auto* const context = &peers.context;
  const auto [first, second] = peers.sessions;
  CHECK(C::session_is_awaited(context, first, 1) == DETENT_OK);  // nothing has arrived from it
  peers.ticks(60);
  CHECK(C::session_is_awaited(context, first, 1) == DETENT_NO);
  std::uint32_t matched = 0;
  REQUIRE(C::session_matched(context, first, 1, &matched) == DETENT_OK);
  CHECK(matched > 20);
  CHECK(matched <= peers.frame(0));

  REQUIRE(C::session_pause(context, second, 1) == DETENT_OK);
  peers.ticks(30);
  const auto frame = peers.frame(0);
  peers.ticks(30);
  CHECK(peers.frame(0) == frame);
  CHECK((peers.states[0] == DETENT_PAUSED && peers.states[1] == DETENT_PAUSED));
  CHECK(peers.happened(0, DETENT_PEER_PAUSED));
  REQUIRE(C::session_pause(context, second, 0) == DETENT_OK);
  peers.ticks(60);
  CHECK(peers.frame(0) > frame + 30);
  CHECK(peers.happened(0, DETENT_PEER_RESUMED));

  peers.is_connected = false;
  peers.ticks(60);
  CHECK(peers.states[0] == DETENT_STARVED);
  CHECK(C::session_is_awaited(context, first, 1) == DETENT_OK);
  const auto stopped = peers.frame(0);
  REQUIRE(C::session_drop(context, first, 1) == DETENT_OK);
  peers.ticks(60);
  CHECK(peers.frame(0) > stopped + 30);
  CHECK(C::session_is_awaited(context, first, 1) == DETENT_NO);
  CHECK(peers.happened(0, DETENT_LEFT));
  CHECK(C::session_drop(context, peers.worlds[0], 1) == DETENT_BAD_HANDLE);
  CHECK(C::session_pause(nullptr, first, 1) == DETENT_BAD_CONTEXT);
}

TEST_CASE("C sessions: peers pause, resume and drop one another, in 2D") { check_control<2>(); }
TEST_CASE("C sessions: peers pause, resume and drop one another, in 3D") { check_control<3>(); }

template <int N>
void check_defaults() {
  using C = Calls<N>;
  detent_context context{};
  REQUIRE(detent_open(&context, nullptr) == DETENT_OK);
  typename Types<N>::Settings settings{};
  REQUIRE(C::world_default_settings(&settings) == DETENT_OK);
  CHECK(C::world_default_settings(nullptr) == DETENT_BAD_ARGUMENT);
  std::array<detent_handle, 2> worlds{};
  REQUIRE(C::world_create(&context, &settings, &worlds[0]) == DETENT_OK);
  REQUIRE(C::world_create(&context, nullptr, &worlds[1]) == DETENT_OK);
  std::array<std::uint64_t, 2> digests{};
  for (std::size_t i = 0; i < 2; ++i) {
    typename Types<N>::Shape ball{};
    ball.kind = DETENT_SPHERE;
    ball.as.sphere.radius = 65536;
    detent_id id{};
    std::uint32_t size = 7;
    CHECK(C::world_size(&context, worlds[i], &size) == DETENT_OK);
    CHECK(size == 0);
    REQUIRE(C::world_add(&context, worlds[i], &ball, nullptr, &id) == DETENT_OK);
    CHECK(C::world_size(&context, worlds[i], &size) == DETENT_OK);
    CHECK(size == 1);
    for (int tick = 0; tick < 10; ++tick) REQUIRE(C::world_step(&context, worlds[i]) == DETENT_OK);
    REQUIRE(C::world_digest(&context, worlds[i], &digests[i]) == DETENT_OK);
  }
  CHECK(digests[0] == digests[1]);
  CHECK(detent_close(&context) == DETENT_OK);
}

TEST_CASE("C worlds: without settings they have the default ones") {
  check_defaults<2>();
  check_defaults<3>();
}

TEST_CASE("C: versions are those of C++") {
  CHECK(detent_version() ==
        DETENT_VERSION_MAJOR * 10000 + DETENT_VERSION_MINOR * 100 + DETENT_VERSION_PATCH);
  CHECK(detent_results_version() == detent::results_version);
}

}  // namespace
