// SPDX-License-Identifier: MIT
//
// What a game does with a session of the C interface next to playing: it pauses, goes on, and drops a
// peer. Versions and defaults are those of C++.

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "detent.h"
#include "detent/version.hpp"
#include "support/catch.hpp"

namespace {

template <int N>
struct Calls;
#define DETENT_TEST_CALLS(N)                                                     \
  template <>                                                                    \
  struct Calls<N> {                                                              \
    using Shape = detent_shape##N;                                               \
    using Settings = detent_world##N##_settings;                                 \
    static constexpr auto create_world = detent_world##N##_create;               \
    static constexpr auto default_settings = detent_world##N##_default_settings; \
    static constexpr auto add = detent_world##N##_add;                           \
    static constexpr auto size = detent_world##N##_size;                         \
    static constexpr auto step = detent_world##N##_step;                         \
    static constexpr auto digest = detent_world##N##_digest;                     \
    static constexpr auto create = detent_session##N##_create;                   \
    static constexpr auto world = detent_session##N##_world;                     \
    static constexpr auto receive = detent_session##N##_receive;                 \
    static constexpr auto packet = detent_session##N##_packet;                   \
    static constexpr auto begin_frame = detent_session##N##_begin_frame;         \
    static constexpr auto end_frame = detent_session##N##_end_frame;             \
    static constexpr auto event = detent_session##N##_event;                     \
    static constexpr auto status = detent_session##N##_status;                   \
    static constexpr auto matched = detent_session##N##_matched;                 \
    static constexpr auto is_awaited = detent_session##N##_is_awaited;           \
    static constexpr auto drop = detent_session##N##_drop;                       \
    static constexpr auto pause = detent_session##N##_pause;                     \
  };
DETENT_TEST_CALLS(2)
DETENT_TEST_CALLS(3)
#undef DETENT_TEST_CALLS

/// Two peers in one context, whose packets come in the next tick; or do not come.
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
    REQUIRE(C::create_world(&context, nullptr, &start) == DETENT_OK);
    typename C::Shape ball{};
    ball.kind = DETENT_SPHERE;
    ball.as.sphere.radius = 65536;
    detent_id id{};
    REQUIRE(C::add(&context, start, &ball, nullptr, &id) == DETENT_OK);
    for (std::uint32_t self = 0; self < 2; ++self) {
      detent_session_settings settings{};
      REQUIRE(detent_session_default_settings(&settings) == DETENT_OK);
      settings.self = self;
      settings.input_size = 1;
      REQUIRE(C::create(&context, &settings, start, &sessions[self]) == DETENT_OK);
      REQUIRE(C::world(&context, sessions[self], &worlds[self]) == DETENT_OK);
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
      REQUIRE(C::receive(&context, sessions[one.to], 1 - one.to, one.bytes.data(), one.size, now) ==
              DETENT_OK);
    }
    for (std::uint32_t self = 0; self < 2; ++self) {
      const auto input = static_cast<std::uint8_t>(self);
      std::array<std::uint8_t, 2> inputs{};
      detent_frame frame{};
      while (C::begin_frame(&context, sessions[self], &input, &frame, inputs.data()) == DETENT_OK) {
        REQUIRE(C::step(&context, worlds[self]) == DETENT_OK);
        REQUIRE(C::end_frame(&context, sessions[self]) == DETENT_OK);
      }
      states[self] = frame.state;
      Packet packet{};
      while (C::packet(&context, sessions[self], now, &packet.to, packet.bytes.data(),
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
    REQUIRE(C::status(&context, sessions[self], &status) == DETENT_OK);
    return status.frame;
  }
  /// Whether this event is among those that happened since.
  bool happened(std::uint32_t self, std::uint32_t kind) {
    bool is_there = false;
    detent_session_event event{};
    while (C::event(&context, sessions[self], &event, nullptr, 0) == DETENT_OK) {
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
  CHECK(C::is_awaited(context, first, 1) == DETENT_OK);  // nothing came from it
  peers.ticks(60);
  CHECK(C::is_awaited(context, first, 1) == DETENT_NO);
  std::uint32_t matched = 0;
  REQUIRE(C::matched(context, first, 1, &matched) == DETENT_OK);
  CHECK(matched > 20);
  CHECK(matched <= peers.frame(0));

  REQUIRE(C::pause(context, second, 1) == DETENT_OK);
  peers.ticks(30);
  const auto frame = peers.frame(0);
  peers.ticks(30);
  CHECK(peers.frame(0) == frame);
  CHECK((peers.states[0] == DETENT_PAUSED && peers.states[1] == DETENT_PAUSED));
  CHECK(peers.happened(0, DETENT_PEER_PAUSED));
  REQUIRE(C::pause(context, second, 0) == DETENT_OK);
  peers.ticks(60);
  CHECK(peers.frame(0) > frame + 30);
  CHECK(peers.happened(0, DETENT_PEER_RESUMED));

  peers.is_connected = false;
  peers.ticks(60);
  CHECK(peers.states[0] == DETENT_STARVED);
  CHECK(C::is_awaited(context, first, 1) == DETENT_OK);
  const auto stopped = peers.frame(0);
  REQUIRE(C::drop(context, first, 1) == DETENT_OK);
  peers.ticks(60);
  CHECK(peers.frame(0) > stopped + 30);
  CHECK(C::is_awaited(context, first, 1) == DETENT_NO);
  CHECK(peers.happened(0, DETENT_LEFT));
  CHECK(C::drop(context, peers.worlds[0], 1) == DETENT_BAD_HANDLE);
  CHECK(C::pause(nullptr, first, 1) == DETENT_BAD_CONTEXT);
}

TEST_CASE("C sessions: peers pause, go on and drop one another, in 2D") { check_control<2>(); }
TEST_CASE("C sessions: peers pause, go on and drop one another, in 3D") { check_control<3>(); }

template <int N>
void check_defaults() {
  using C = Calls<N>;
  detent_context context{};
  REQUIRE(detent_open(&context, nullptr) == DETENT_OK);
  typename C::Settings settings{};
  REQUIRE(C::default_settings(&settings) == DETENT_OK);
  CHECK(C::default_settings(nullptr) == DETENT_BAD_ARGUMENT);
  std::array<detent_handle, 2> worlds{};
  REQUIRE(C::create_world(&context, &settings, &worlds[0]) == DETENT_OK);
  REQUIRE(C::create_world(&context, nullptr, &worlds[1]) == DETENT_OK);
  std::array<std::uint64_t, 2> digests{};
  for (std::size_t i = 0; i < 2; ++i) {
    typename C::Shape ball{};
    ball.kind = DETENT_SPHERE;
    ball.as.sphere.radius = 65536;
    detent_id id{};
    std::uint32_t size = 7;
    CHECK(C::size(&context, worlds[i], &size) == DETENT_OK);
    CHECK(size == 0);
    REQUIRE(C::add(&context, worlds[i], &ball, nullptr, &id) == DETENT_OK);
    CHECK(C::size(&context, worlds[i], &size) == DETENT_OK);
    CHECK(size == 1);
    for (int tick = 0; tick < 10; ++tick) REQUIRE(C::step(&context, worlds[i]) == DETENT_OK);
    REQUIRE(C::digest(&context, worlds[i], &digests[i]) == DETENT_OK);
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
