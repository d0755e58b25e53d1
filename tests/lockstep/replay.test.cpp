// SPDX-License-Identifier: MIT
#include "detent/lockstep/replay.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "lockstep/toy.hpp"
#include "support/catch.hpp"

using namespace detent;
using namespace detent::test;

namespace {

using Bytes = std::vector<std::byte>;
using Reader = ReplayReader<Pad>;

struct Recorded {
  Bytes bytes;
  std::vector<std::size_t> ends;  // of head and blocks
  Toy last;
};

/// A match of `frames` frames in which player 1 leaves half-way; inputs change once in `keep`.
Recorded record(std::uint32_t frames, std::size_t every, std::uint64_t keep, std::uint64_t seed,
                std::uint32_t broken = ~0u) {
  Recorded result;
  const auto sink = [&](std::span<const std::byte> bytes) {
    result.bytes.insert(result.bytes.end(), bytes.begin(), bytes.end());
  };
  Random random(seed);
  ReplayWriter<Pad> writer(every);
  const Bytes snapshot{std::byte{7}, std::byte{8}, std::byte{9}};
  writer.begin({.kind = "toy", .players = 3, .snapshot = snapshot}, sink);
  result.ends.push_back(result.bytes.size());
  std::array<Pad, 3> pads{};
  for (std::uint32_t frame = 0; frame < frames; ++frame) {
    FrameInputs<Pad, 8> inputs(frame, 3);
    for (std::size_t i = 0; i < 3; ++i) {
      if (random.one_in(keep)) {
        pads[i] = {static_cast<std::int16_t>(random.between(-400, 400)), random.coin()};
      }
      if (i != 1 || frame < frames / 2) inputs.set(i, pads[i]);
    }
    simulate(result.last, inputs);
    if (frame == broken) result.last.mixed ^= 1;
    const auto before = result.bytes.size();
    writer.add(inputs, result.last, sink);
    if (result.bytes.size() > before) result.ends.push_back(result.bytes.size());
  }
  writer.end(result.last, sink);
  if (result.bytes.size() > result.ends.back()) result.ends.push_back(result.bytes.size());
  return result;
}

}  // namespace

TEST_CASE("replay: resimulating gives the recorded digests") {
  for (const std::size_t every : {1u, 7u, 60u, 255u}) {
    const auto recorded = record(1000, every, 8, every);
    const Reader reader(recorded.bytes);
    CHECK(reader.state() == ReplayState::whole);
    CHECK(reader.is_kind("toy"));
    CHECK_FALSE(reader.is_kind("tax"));
    CHECK(reader.players() == 3);
    REQUIRE(reader.snapshot().size() == 3);
    CHECK(reader.snapshot()[2] == std::byte{9});
    const auto check = check_replay<Pad>(reader, Toy{}, play);
    CHECK(check.state == ReplayState::whole);
    CHECK(check.frames == 1000);
    CHECK(check.equal == 1000);
    CHECK(check.is_equal);
  }
}

TEST_CASE("replay: the first frame that differs is in the named block") {
  for (const std::uint32_t broken : {0u, 1u, 59u, 60u, 333u, 999u}) {
    INFO("frame " << broken);
    for (const std::size_t every : {1u, 60u}) {
      const auto recorded = record(1000, every, 8, 5, broken);
      const auto check = check_replay<Pad>(Reader(recorded.bytes), Toy{}, play);
      CHECK_FALSE(check.is_equal);
      CHECK(check.equal == broken / every * every);
      CHECK(check.frames == std::min<std::size_t>(check.equal + every, 1000));
    }
  }
}

TEST_CASE("replay: a block cut off by a crash is left out, and everything before it is read") {
  const auto recorded = record(300, 20, 4, 9);
  for (std::size_t size = 0; size <= recorded.bytes.size(); ++size) {
    const auto cut = std::span<const std::byte>(recorded.bytes).first(size);
    const auto check = check_replay<Pad>(Reader(cut), Toy{}, play);
    const auto blocks =
        std::upper_bound(recorded.ends.begin(), recorded.ends.end(), size) - recorded.ends.begin();
    if (blocks == 0) {
      CHECK(check.state == ReplayState::no_replay);
      CHECK(check.frames == 0);
      continue;
    }
    const bool is_whole = recorded.ends[static_cast<std::size_t>(blocks - 1)] == size;
    CHECK(check.state == (is_whole ? ReplayState::whole : ReplayState::cut));
    CHECK(check.frames == 20 * (blocks - 1));
    CHECK(check.is_equal);
  }
}

TEST_CASE("replay: a changed byte is detected, and the frames before it are read") {
  const auto recorded = record(100, 10, 4, 11);
  for (std::size_t i = 0; i < recorded.bytes.size(); ++i) {
    auto bytes = recorded.bytes;
    bytes[i] ^= std::byte{16};
    const auto check = check_replay<Pad>(Reader(bytes), Toy{}, play);
    CHECK(check.state != ReplayState::whole);
    CHECK(check.is_equal);
    const auto blocks =
        std::upper_bound(recorded.ends.begin(), recorded.ends.end(), i) - recorded.ends.begin();
    CHECK(check.equal == (blocks == 0 ? 0 : 10 * (blocks - 1)));
  }
}

TEST_CASE("replay: reports other inputs, players or results") {
  const auto recorded = record(10, 5, 4, 13);
  CHECK(ReplayReader<int>(recorded.bytes).state() == ReplayState::other_inputs);
  CHECK((ReplayReader<Pad, 2>(recorded.bytes).state()) == ReplayState::other_inputs);
  Bytes other;
  ReplayWriter<Pad> writer;
  writer.begin({.kind = "toy", .players = 3, .results = 99, .snapshot = {}},
               [&](std::span<const std::byte> bytes) {
                 other.insert(other.end(), bytes.begin(), bytes.end());
               });
  CHECK(Reader(other).state() == ReplayState::other_results);
}

TEST_CASE("replay: a session's final frames are its replay") {
  SessionConfig config;
  config.delay = 1;
  ToySession a(config, Toy{});
  config.self = 1;
  ToySession b(config, Toy{});
  Bytes bytes;
  const auto sink = [&](std::span<const std::byte> more) {
    bytes.insert(bytes.end(), more.begin(), more.end());
  };
  ReplayWriter<Pad> writer(10);
  writer.begin({.kind = "toy", .snapshot = {}}, sink);
  std::uint32_t recorded = 0;
  for (std::uint64_t now = 0; now < 300 * 16'667; now += 16'667) {
    const auto to_b = [&](std::size_t, auto packet) { b.receive(0, packet, now); };
    const auto to_a = [&](std::size_t, auto packet) { a.receive(1, packet, now); };
    if (now % 5 != 0) a.poll(now, to_b);
    if (now % 3 != 0) b.poll(now, to_a);
    a.advance({static_cast<std::int16_t>(now % 7), false}, play);
    b.advance({static_cast<std::int16_t>(now % 4), now % 6 == 0}, play);
    for (; recorded < a.final_frame() && a.result(recorded) != nullptr; ++recorded) {
      writer.add(a.inputs(recorded).value(), *a.result(recorded), sink);
    }
  }
  CHECK(a.resimulated() > 0);
  const auto check = check_replay<Pad>(Reader(bytes), Toy{}, play);
  CHECK(check.state == ReplayState::whole);
  CHECK(check.is_equal);
  CHECK(check.equal > 250);
}

TEST_CASE("replay: takes less than two bytes per frame") {
  const auto idle = record(6000, 60, 1'000'000, 1), busy = record(6000, 60, 24, 1);
  CHECK(idle.bytes.size() < 6000 * 17 / 20);
  CHECK(busy.bytes.size() < 6000 * 2);
}
