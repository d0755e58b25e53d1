// SPDX-License-Identifier: MIT
//
// Sessions and replays of the C interface: two peers end in the world that plain steps give, a
// planted difference is named, and worlds change only during frames.

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <utility>
#include <vector>

#include "detent.h"
#include "support/catch.hpp"

namespace {

constexpr std::int32_t one = 65536;
constexpr std::uint32_t pad_size = 3;
using Pad = std::array<std::uint8_t, pad_size>;

/// A player's input in a frame: which ball it pushes, and how.
Pad pressed(std::uint32_t frame, std::uint32_t player) {
  if (frame >= 100) return {};
  const auto k = frame / (5 + 2 * player);
  return {static_cast<std::uint8_t>(k % 3), static_cast<std::uint8_t>(k % 7),
          static_cast<std::uint8_t>(k % 2)};
}

/// A world of three balls in a bowl, for two players.
class Arena {
 public:
  explicit Arena(detent_allocator* allocator = nullptr) {
    REQUIRE(detent_open(&context, allocator) == DETENT_OK);
    start = make();
  }
  Arena(const Arena&) = delete;
  Arena& operator=(const Arena&) = delete;
  ~Arena() { detent_close(&context); }

  detent_handle make() {
    detent_handle world = 0;
    REQUIRE(detent_world2_create(&context, nullptr, &world) == DETENT_OK);
    detent_shape2 shape{};
    shape.kind = DETENT_AABB;
    shape.as.aabb = {{-20 * one, -one}, {20 * one, 0}};
    detent_body2_options options{};
    detent_body2_default_options(&options);
    options.motion = DETENT_FIXED_BODY;
    detent_id id{};
    REQUIRE(detent_world2_add(&context, world, &shape, &options, &id) == DETENT_OK);
    for (std::int32_t i = 0; i < 3; ++i) {
      shape = {};
      shape.kind = DETENT_SPHERE;
      shape.as.sphere = {{2 * i * one, one}, one / 2};
      auto& ball = balls[static_cast<std::size_t>(i)];
      REQUIRE(detent_world2_add(&context, world, &shape, nullptr, &ball) == DETENT_OK);
    }
    return world;
  }

  void push(detent_handle world, const Pad& pad) {
    if (pad[1] == 0) return;
    const detent_vec2 velocity{(pad[1] - 3) * one, pad[2] * one};
    REQUIRE(detent_world2_set_velocity(&context, world, balls[pad[0]], &velocity) == DETENT_OK);
  }
  /// The game's rules in a frame of a session or replay.
  void simulate(detent_handle world, const detent_frame& frame, const std::uint8_t* inputs) {
    std::array<std::uint32_t, 3> words{};
    REQUIRE(detent_world2_words(&context, world, words.data()) == DETENT_OK);
    for (std::uint32_t player = 0; player < frame.players; ++player) {
      if (((frame.present >> player) & 1) == 0) continue;
      Pad pad;
      for (std::size_t i = 0; i < pad_size; ++i) pad[i] = inputs[pad_size * player + i];
      push(world, pad);
      words[player] += pad[1];
    }
    words[2] = frame.number + 1;
    REQUIRE(detent_world2_set_words(&context, world, words.data()) == DETENT_OK);
    REQUIRE(detent_world2_step(&context, world) == DETENT_OK);
  }
  std::uint64_t digest(detent_handle world) {
    std::uint64_t result = 0;
    REQUIRE(detent_world2_digest(&context, world, &result) == DETENT_OK);
    return result;
  }

  detent_session_settings settings(std::uint32_t self) {
    detent_session_settings result{};
    REQUIRE(detent_session_default_settings(&result) == DETENT_OK);
    result.match = 99;
    result.self = self;
    result.input_size = pad_size;
    result.words = 3;
    return result;
  }

  detent_context context{};
  detent_handle start = 0;
  std::array<detent_id, 3> balls{};
};

struct Event {
  detent_session_event what;
  std::string name;
};

/// A session and its events.
struct Peer {
  Peer(Arena& own, const detent_session_settings& settings) : arena(&own) {
    REQUIRE(detent_session2_create(&own.context, &settings, own.start, &session) == DETENT_OK);
    REQUIRE(detent_session2_world(&own.context, session, &world) == DETENT_OK);
    self = settings.self;
    update();
  }
  void update() { REQUIRE(detent_session2_status(&arena->context, session, &status) == DETENT_OK); }
  /// Plays up to `frames` frames, and calls change(world, frame) in each.
  template <class Change>
  void play(std::uint32_t frames, const Change& change) {
    const auto pad = pressed(status.frame, self);
    detent_frame frame{};
    std::array<std::uint8_t, 2 * pad_size> inputs{};
    while (status.frame < frames &&
           detent_session2_begin_frame(&arena->context, session, pad.data(), &frame,
                                       inputs.data()) == DETENT_OK) {
      arena->simulate(world, frame, inputs.data());
      change(world, frame.number);
      REQUIRE(detent_session2_end_frame(&arena->context, session) == DETENT_OK);
    }
    state = frame.state;
    update();
    detent_session_event event{};
    std::array<char, DETENT_NAME> name{};
    while (detent_session2_event(&arena->context, session, &event, name.data(), DETENT_NAME) ==
           DETENT_OK) {
      REQUIRE(event.name_size <= DETENT_NAME);
      events.push_back({event, std::string(name.data(), event.name_size)});
    }
  }
  [[nodiscard]] const Event* find(std::uint32_t kind) const {
    for (const auto& event : events) {
      if (event.what.kind == kind) return &event;
    }
    return nullptr;
  }

  Arena* arena;
  detent_handle session = 0, world = 0;
  detent_session_status status{};
  std::uint32_t self = 0, state = 0;
  std::vector<Event> events;
};

/// Packets between peers with a delay of some ticks; every fifth is lost.
class Wire {
 public:
  void deliver(std::vector<Peer*> peers, std::uint64_t now) {
    for (; packets_.size() > 4 * peers.size(); packets_.pop_front()) {
      const auto& packet = packets_.front();
      Peer* const to = peers[packet.to];
      if (to == nullptr) continue;
      const auto status = detent_session2_receive(
          &to->arena->context, to->session, packet.from, packet.bytes.data(),
          static_cast<std::uint32_t>(packet.bytes.size()), now);
      REQUIRE(status >= DETENT_NO);
    }
  }
  void collect(Peer& peer, std::uint64_t now) {
    std::vector<std::uint8_t> room(DETENT_PACKET);
    std::uint32_t to = 0, size = 0;
    while (detent_session2_packet(&peer.arena->context, peer.session, now, &to, room.data(),
                                  DETENT_PACKET, &size) == DETENT_OK) {
      if (++count_ % 5 == 0) continue;
      packets_.push_back({peer.self, to, {room.begin(), room.begin() + size}});
    }
  }

 private:
  struct Packet {
    std::uint32_t from, to;
    std::vector<std::uint8_t> bytes;
  };
  std::deque<Packet> packets_;
  std::uint32_t count_ = 0;
};

constexpr std::uint64_t tick = 16667;

TEST_CASE("C sessions: two peers end in the world that plain steps give") {
  Arena arena;
  Peer a(arena, arena.settings(0)), b(arena, arena.settings(1));
  Wire wire;
  constexpr std::uint32_t frames = 150;
  std::uint64_t now = 0;
  const auto nothing = [](detent_handle, std::uint32_t) {};
  for (; (a.status.frame < frames || b.status.frame < frames) && now < 400 * tick; now += tick) {
    wire.deliver({&a, &b}, now);
    for (Peer* const peer : {&a, &b}) {
      peer->play(frames, nothing);
      wire.collect(*peer, now);
    }
  }
  const auto plain = arena.make();
  std::array<std::uint32_t, 3> sums{0, 0, frames};
  for (std::uint32_t frame = 0; frame < frames; ++frame) {
    for (std::uint32_t player = 0; player < 2 && frame >= 2; ++player) {
      const auto pad = pressed(frame - 2, player);  // the input delay
      arena.push(plain, pad);
      sums[player] += pad[1];
    }
    REQUIRE(detent_world2_step(&arena.context, plain) == DETENT_OK);
  }
  for (const Peer* const peer : {&a, &b}) {
    CHECK(peer->status.frame == frames);
    CHECK(peer->status.resimulated > 20);
    CHECK(peer->status.final_frame > frames - 20);
    CHECK(peer->status.is_player == 1);
    CHECK(arena.digest(peer->world) == arena.digest(plain));
    std::array<std::uint32_t, 3> words{};
    CHECK(detent_world2_words(&arena.context, peer->world, words.data()) == DETENT_OK);
    CHECK(words == sums);
    REQUIRE(peer->events.size() == 1);
    CHECK(peer->events[0].what.kind == DETENT_CONNECTED);
    std::uint32_t matched = 0;
    CHECK(detent_session2_matched(&arena.context, peer->session, 1 - peer->self, &matched) ==
          DETENT_OK);
    CHECK(matched > frames - 40);
  }
}

TEST_CASE("C sessions: a desync is named by its frame, body and field") {
  Arena arena;
  Peer a(arena, arena.settings(0)), b(arena, arena.settings(1));
  Wire wire;
  const auto nothing = [](detent_handle, std::uint32_t) {};
  const auto cheat = [&](detent_handle world, std::uint32_t frame) {
    const detent_vec2 up{0, one};
    if (frame == 60) detent_world2_set_velocity(&arena.context, world, arena.balls[1], &up);
  };
  for (std::uint64_t now = 0; now < 200 * tick; now += tick) {
    wire.deliver({&a, &b}, now);
    a.play(1000, nothing);
    b.play(1000, cheat);
    wire.collect(a, now);
    wire.collect(b, now);
  }
  for (const Peer* const peer : {&a, &b}) {
    const Event* const frame = peer->find(DETENT_DESYNC);
    REQUIRE(frame != nullptr);
    CHECK(frame->what.frame == 60);
    CHECK(frame->what.peer == 1 - peer->self);
    const Event* const field = peer->find(DETENT_DESYNC_FIELD);
    REQUIRE(field != nullptr);
    CHECK(field->name.find("body " + std::to_string(arena.balls[1].index) + ":") == 0);
    CHECK(field->name.find("velocity") != std::string::npos);
  }
}

TEST_CASE("C sessions: a late joiner gets the match and its seat") {
  Arena arena;
  auto settings = arena.settings(0);
  settings.players = 2;
  settings.absent = 2;
  Peer a(arena, settings);
  Peer* late = nullptr;
  std::vector<Peer> guests;
  Wire wire;
  const auto nothing = [](detent_handle, std::uint32_t) {};
  for (std::uint64_t now = 0; now < 300 * tick; now += tick) {
    wire.deliver({&a, late}, now);
    a.play(1000, nothing);
    wire.collect(a, now);
    if (now == 100 * tick) {
      settings.self = 1;
      settings.life = 7;
      guests.emplace_back(arena, settings);
      late = &guests.front();
    }
    if (late == nullptr) continue;
    late->play(1000, nothing);
    if (now == 100 * tick) CHECK(late->state == DETENT_JOINING);
    wire.collect(*late, now);
  }
  REQUIRE(late != nullptr);
  CHECK(late->find(DETENT_LOADED) != nullptr);
  CHECK(late->find(DETENT_JOINED) != nullptr);
  CHECK(a.find(DETENT_JOINED) != nullptr);
  CHECK(a.find(DETENT_DESYNC) == nullptr);
  CHECK(late->status.is_player == 1);
  CHECK(late->status.start_frame >= 50);
  CHECK(late->status.final_frame > 200);
}

TEST_CASE("C sessions: their worlds change only during frames, and live as long as they do") {
  Arena arena;
  detent_context* const context = &arena.context;
  auto settings = arena.settings(0);
  settings.players = 1;
  Peer peer(arena, settings);
  const detent_vec2 velocity{one, 0};
  const auto ball = arena.balls[0];
  std::array<std::uint32_t, 3> words{1, 2, 3};
  CHECK(detent_world2_step(context, peer.world) == DETENT_NOT_NOW);
  CHECK(detent_world2_remove(context, peer.world, ball) == DETENT_NOT_NOW);
  CHECK(detent_world2_set_words(context, peer.world, words.data()) == DETENT_NOT_NOW);
  CHECK(detent_world2_destroy(context, peer.world) == DETENT_IN_USE);
  CHECK(detent_world2_words(context, arena.start, words.data()) == DETENT_NO);
  CHECK(detent_session2_end_frame(context, peer.session) == DETENT_NOT_NOW);

  // A frame that was not ended is opened again in its original state.
  const Pad pad{};
  detent_frame frame{};
  std::array<std::uint8_t, pad_size> inputs{};
  const auto before = arena.digest(peer.world);
  for (int i = 0; i < 2; ++i) {
    REQUIRE(detent_session2_begin_frame(context, peer.session, pad.data(), &frame, inputs.data()) ==
            DETENT_OK);
    CHECK(frame.number == 0);
    CHECK(arena.digest(peer.world) == before);
    CHECK(detent_world2_set_velocity(context, peer.world, ball, &velocity) == DETENT_OK);
    CHECK(detent_world2_step(context, peer.world) == DETENT_OK);
    CHECK(arena.digest(peer.world) != before);
  }
  CHECK(detent_session2_end_frame(context, peer.session) == DETENT_OK);
  CHECK(detent_session2_end_frame(context, peer.session) == DETENT_NOT_NOW);
  const auto after = arena.digest(peer.world);
  CHECK(detent_world2_step(context, arena.start) == DETENT_OK);  // the session has a copy
  CHECK(arena.digest(peer.world) == after);

  const detent_vec2 corners[3] = {{0, 0}, {one, 0}, {0, one}};
  detent_handle solid = 0, hull = 0;
  CHECK(detent_solid2_create(context, 5, corners, 3, &solid) == DETENT_OK);
  CHECK(detent_hull2_create(context, 5, corners, 3, &hull) == DETENT_OK);
  CHECK(detent_asset_destroy(context, solid) == DETENT_IN_USE);  // an earlier world may use it
  CHECK(detent_asset_destroy(context, hull) == DETENT_OK);
  CHECK(detent_session2_destroy(context, peer.session) == DETENT_OK);
  CHECK(detent_session2_destroy(context, peer.session) == DETENT_BAD_HANDLE);
  CHECK(detent_world2_step(context, peer.world) == DETENT_BAD_HANDLE);
  CHECK(detent_asset_destroy(context, solid) == DETENT_OK);
}

TEST_CASE("C sessions: wrong arguments are errors") {
  Arena arena;
  detent_context* const context = &arena.context;
  detent_handle session = 0;
  const auto refused = [&](auto change) {
    auto settings = arena.settings(0);
    change(settings);
    return detent_session2_create(context, &settings, arena.start, &session) ==
               DETENT_BAD_ARGUMENT &&
           session == 0;
  };
  CHECK(refused([](auto& s) { s.players = 0; }));
  CHECK(refused([](auto& s) { s.players = 9; }));
  CHECK(refused([](auto& s) { s.spectators = 15; }));
  CHECK(refused([](auto& s) { s.spectators = 0xffffffff; }));
  CHECK(refused([](auto& s) { s.self = 2; }));
  CHECK(refused([](auto& s) { s.delay = 9; }));
  CHECK(refused([](auto& s) { s.prediction = 17; }));
  CHECK(refused([](auto& s) { s.prediction = s.delay = 0; }));
  CHECK(refused([](auto& s) { s.frames_per_call = 0; }));
  CHECK(refused([](auto& s) { s.absent = 4; }));
  CHECK(refused([](auto& s) { s.wants_seat = 2; }));
  CHECK(refused([](auto& s) { s.input_size = 0; }));
  CHECK(refused([](auto& s) { s.input_size = 17; }));
  CHECK(refused([](auto& s) { s.words = 257; }));
  CHECK(refused([](auto& s) { s.replay_every = 256; }));
  auto settings = arena.settings(0);
  CHECK(detent_session2_create(context, nullptr, arena.start, &session) == DETENT_BAD_ARGUMENT);
  CHECK(detent_session2_create(context, &settings, arena.start, nullptr) == DETENT_BAD_ARGUMENT);
  CHECK(detent_session2_create(context, &settings, 0, &session) == DETENT_BAD_HANDLE);
  CHECK(detent_session2_create(nullptr, &settings, arena.start, &session) == DETENT_BAD_CONTEXT);
  CHECK(detent_session3_create(context, &settings, arena.start, &session) == DETENT_BAD_HANDLE);
  REQUIRE(detent_session2_create(context, &settings, arena.start, &session) == DETENT_OK);
  const Pad pad{};
  detent_frame frame{};
  std::array<std::uint8_t, 2 * pad_size> inputs{};
  std::array<std::uint8_t, DETENT_PACKET> room{};
  std::uint32_t peer = 0, size = 1;
  CHECK(detent_session2_begin_frame(context, session, nullptr, &frame, inputs.data()) ==
        DETENT_BAD_ARGUMENT);
  CHECK(detent_session2_begin_frame(context, session, pad.data(), nullptr, inputs.data()) ==
        DETENT_BAD_ARGUMENT);
  CHECK(detent_session2_begin_frame(context, session, pad.data(), &frame, inputs.data()) ==
        DETENT_NO);
  CHECK(frame.state == DETENT_CONNECTING);
  CHECK(detent_session2_packet(context, session, 0, &peer, room.data(), DETENT_PACKET - 1, &size) ==
        DETENT_BAD_ARGUMENT);
  CHECK(detent_session2_receive(context, session, 1, nullptr, 1, 0) == DETENT_BAD_ARGUMENT);
  CHECK(detent_session2_receive(context, session, 1, room.data(), 100, 0) == DETENT_NO);
  CHECK(detent_session2_receive(context, arena.start, 1, room.data(), 100, 0) == DETENT_BAD_HANDLE);
  CHECK(detent_session2_is_awaited(context, session, 1) == DETENT_OK);
  CHECK(detent_session2_is_awaited(context, session, 77) == DETENT_NO);
  CHECK(detent_session2_drop(context, session, 2) == DETENT_BAD_ARGUMENT);
  CHECK(detent_session2_pause(context, session, 2) == DETENT_BAD_ARGUMENT);
  CHECK(detent_session2_replay(context, session, nullptr, 0, &size) == DETENT_NO);
  CHECK(size == 0);  // it records none
}

/// A replay of one player, and its number of frames.
std::vector<std::uint8_t> recorded(Arena& arena, std::uint32_t frames) {
  auto settings = arena.settings(0);
  settings.players = 1;
  settings.replay_every = 10;
  Peer peer(arena, settings);
  while (peer.status.frame < frames) peer.play(frames, [](detent_handle, std::uint32_t) {});
  std::uint32_t size = 0;
  CHECK(detent_session2_replay(&arena.context, peer.session, nullptr, 0, &size) == DETENT_NO);
  std::vector<std::uint8_t> bytes(size);
  CHECK(detent_session2_replay(&arena.context, peer.session, bytes.data(), size, &size) ==
        DETENT_OK);
  CHECK(detent_session2_destroy(&arena.context, peer.session) == DETENT_OK);
  return bytes;
}

detent_replay_check checked(Arena& arena, const std::vector<std::uint8_t>& bytes,
                            std::uint32_t cheat = 0xffffffff) {
  detent_handle replay = 0, world = 0;
  REQUIRE(detent_replay2_create(&arena.context, bytes.data(),
                                static_cast<std::uint32_t>(bytes.size()), arena.start, pad_size, 3,
                                &replay) == DETENT_OK);
  REQUIRE(detent_replay2_world(&arena.context, replay, &world) == DETENT_OK);
  detent_frame frame{};
  std::array<std::uint8_t, pad_size> inputs{};
  while (detent_replay2_begin_frame(&arena.context, replay, &frame, inputs.data()) == DETENT_OK) {
    arena.simulate(world, frame, inputs.data());
    if (frame.number == cheat) arena.push(world, {1, 1, 1});
    REQUIRE(detent_replay2_end_frame(&arena.context, replay) == DETENT_OK);
  }
  CHECK(detent_world2_step(&arena.context, world) == DETENT_NOT_NOW);
  detent_replay_check check{};
  REQUIRE(detent_replay2_check(&arena.context, replay, &check) == DETENT_OK);
  REQUIRE(detent_replay2_destroy(&arena.context, replay) == DETENT_OK);
  return check;
}

TEST_CASE("C replays: reproduce the recording, and report where they differ") {
  Arena arena;
  auto bytes = recorded(arena, 95);
  auto check = checked(arena, bytes);
  CHECK(check.state == DETENT_REPLAY_WHOLE);
  CHECK(check.frames == 95);
  CHECK(check.equal == 95);
  CHECK(check.is_equal == 1);
  CHECK(check.players == 1);

  check = checked(arena, bytes, 47);
  CHECK(check.is_equal == 0);
  CHECK(check.equal == 40);
  CHECK(check.frames == 50);

  auto cut = bytes;
  cut.resize(cut.size() - 3);
  check = checked(arena, cut);
  CHECK(check.state == DETENT_REPLAY_CUT);
  CHECK(check.frames == 90);
  CHECK(check.is_equal == 1);
  auto corrupted = bytes;
  corrupted[corrupted.size() - 6] ^= 1;
  CHECK(checked(arena, corrupted).state == DETENT_REPLAY_CORRUPTED);

  detent_handle replay = 1;
  const auto create = [&](const std::vector<std::uint8_t>& from, detent_handle world,
                          std::uint32_t size, std::uint32_t words) {
    return detent_replay2_create(&arena.context, from.data(),
                                 static_cast<std::uint32_t>(from.size()), world, size, words,
                                 &replay);
  };
  CHECK(create(bytes, arena.start, pad_size + 1, 3) == DETENT_OTHER_SCENE);
  CHECK(create(bytes, arena.start, pad_size, 2) == DETENT_OTHER_SCENE);
  CHECK(create({bytes.begin(), bytes.begin() + 20}, arena.start, pad_size, 3) ==
        DETENT_NO_SNAPSHOT);
  CHECK(create({}, arena.start, pad_size, 3) == DETENT_NO_SNAPSHOT);
  CHECK(create(bytes, arena.start, 0, 3) == DETENT_BAD_ARGUMENT);
  CHECK(create(bytes, arena.start, pad_size, 257) == DETENT_BAD_ARGUMENT);
  detent_handle other = 0;
  REQUIRE(detent_world2_create(&arena.context, nullptr, &other) == DETENT_OK);
  CHECK(create(bytes, other, pad_size, 3) == DETENT_OTHER_FIXED_PART);
  CHECK(replay == 0);
}

std::string difference(detent_status (*diff)(const detent_context*, detent_handle, detent_handle,
                                             std::uint32_t, void*, std::uint32_t, std::uint32_t*),
                       const detent_context* context, detent_handle a, detent_handle b,
                       std::uint32_t most) {
  std::array<char, 400> names{};
  std::uint32_t size = 0, again = 0;
  const auto status = diff(context, a, b, most, nullptr, 0, &size);
  REQUIRE(status >= DETENT_NO);
  CHECK((status == DETENT_OK) == (size != 0));
  CHECK(diff(context, a, b, most, names.data(), 400, &again) == status);
  CHECK(again == size);
  if (size > 2) {  // less room receives the beginning
    std::array<char, 3> few{'-', '-', '-'};
    CHECK(diff(context, a, b, most, few.data(), 2, &again) == status);
    CHECK(again == size);
    CHECK((few[0] == names[0] && few[1] == names[1] && few[2] == '-'));
  }
  return {names.data(), size};
}

TEST_CASE("C worlds and scenes: diff names what differs") {
  Arena arena;
  detent_context* const context = &arena.context;
  const auto other = arena.make();
  CHECK(difference(detent_world2_diff, context, arena.start, other, 5).empty());
  const detent_vec2 velocity{one, one};
  REQUIRE(detent_world2_set_velocity(context, other, arena.balls[2], &velocity) == DETENT_OK);
  const auto id =
      std::to_string(arena.balls[2].index) + ":" + std::to_string(arena.balls[2].generation);
  CHECK(difference(detent_world2_diff, context, arena.start, other, 1) ==
        "body " + id + " (sphere) velocity.x\n");
  CHECK(difference(detent_world2_diff, context, arena.start, other, 2) ==
        "body " + id + " (sphere) velocity.x\nbody " + id + " (sphere) velocity.y\n");
  std::uint32_t size = 0;
  CHECK(detent_world2_diff(context, arena.start, other, 1, nullptr, 1, &size) ==
        DETENT_BAD_ARGUMENT);
  CHECK(detent_world2_diff(context, arena.start, 0, 1, nullptr, 0, &size) == DETENT_BAD_HANDLE);

  std::array<detent_handle, 2> scenes{};
  for (std::size_t i = 0; i < 2; ++i) {
    REQUIRE(detent_scene3_create(context, &scenes[i]) == DETENT_OK);
    detent_shape3 ball{};
    ball.kind = DETENT_SPHERE;
    ball.as.sphere = {{0, static_cast<std::int32_t>(i), 0}, one};
    detent_id made{};
    REQUIRE(detent_scene3_add(context, scenes[i], &ball, nullptr, &made) == DETENT_OK);
  }
  CHECK(difference(detent_scene3_diff, context, scenes[0], scenes[0], 1).empty());
  CHECK(difference(detent_scene3_diff, context, scenes[0], scenes[1], 9) ==
        "object 0:1 (sphere) center.y\n");
}

}  // namespace
