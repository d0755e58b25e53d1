// SPDX-License-Identifier: MIT
#include "detent/lockstep/packet.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "detent/lockstep/input_queue.hpp"
#include "lockstep/toy.hpp"
#include "support/catch.hpp"

using namespace detent;
using namespace detent::detail;
using detent::test::Pad;

namespace {

enum class Stance : std::uint8_t { low, high };

template <class Input>
Input there_and_back(const Input& input) {
  const auto bytes = bytes_of(input);
  return InputCodec<Input>::read(bytes.data());
}

std::vector<std::byte> bytes_of_list(std::initializer_list<int> list) {
  std::vector<std::byte> bytes;
  for (const int byte : list) bytes.push_back(static_cast<std::byte>(byte));
  return bytes;
}

}  // namespace

TEST_CASE("bits: numbers are read back, lowest bit first") {
  std::array<std::byte, 64> room{};
  BitWriter out(room);
  out.add(5, 3);
  out.add_flag(true);
  out.add_short(7);
  out.add_short(8);
  out.add_short(0xffffffffu);
  out.add_difference(10, 13);
  out.add_difference(3, 0xfffffff0u);
  out.add_difference(0x80000000u, 0);
  out.add(0x0123456789abcdefu, 64);
  REQUIRE(out.has_room());
  CHECK(room[0] == std::byte{0x7d});  // 5, 1, 7
  BitReader in(std::span<const std::byte>(room).first(out.byte_count()));
  CHECK(in.number(3) == 5);
  CHECK(in.flag());
  CHECK(in.short_number() == 7);
  CHECK(in.short_number() == 8);
  CHECK(in.short_number() == 0xffffffffu);
  CHECK(in.difference(13) == 10);
  CHECK(in.difference(0xfffffff0u) == 3);
  CHECK(in.difference(0) == 0x80000000u);
  CHECK(in.number(64) == 0x0123456789abcdefu);
  CHECK(in.is_at_end());
  CHECK(in.number(8) == 0);
  CHECK(in.has_failed());
}

TEST_CASE("bits: a writer without room counts, and a number has one encoding") {
  BitWriter out({});
  out.add(1, 17);
  CHECK(out.byte_count() == 3);
  CHECK_FALSE(out.has_room());
  const auto padded = bytes_of_list({0x08});  // 0 in two groups
  BitReader in(padded);
  (void)in.short_number();
  CHECK(in.has_failed());
  const auto endless = bytes_of_list({0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff});
  BitReader long_one(endless);
  (void)long_one.short_number();
  CHECK(long_one.has_failed());
}

TEST_CASE("input codec: bytes are little-endian, fields one after another") {
  CHECK(InputCodec<Pad>::size == 3);
  const auto bytes = bytes_of(Pad{-2, true});
  CHECK(bytes == std::array{std::byte{0xfe}, std::byte{0xff}, std::byte{1}});
  CHECK(there_and_back(Pad{-2, true}) == Pad{-2, true});
  CHECK(there_and_back(Stance::high) == Stance::high);
  CHECK(there_and_back(q16_16(-3)) == -3);
  CHECK(there_and_back(std::array<int, 2>{1, -70000}) == std::array<int, 2>{1, -70000});
  struct Raw {
    std::uint8_t a, b;
  };
  CHECK(there_and_back(Raw{3, 4}).b == 4);
  // Bytes that no writer produces are still some input, and equal inputs have equal bytes.
  InputBytes<Pad> odd{std::byte{1}, std::byte{0}, std::byte{7}};
  CHECK(canonical<Pad>(odd) == bytes_of(Pad{1, true}));
}

TEST_CASE("input queue: unchanged inputs cost a bit, and runs start at any kept frame") {
  InputQueue<Pad, 128> queue;
  for (int i = 0; i < 100; ++i) {
    queue.push(wire_of<Pad>(bytes_of(Pad{static_cast<std::int16_t>(i / 20 * 300), i == 50})));
  }
  BitWriter idle({});
  queue.write(idle, 1, 19);
  CHECK(idle.bit_count() == 19);
  CHECK(queue.fitting(1, 127, 19) == 19);
  for (const std::uint32_t first : {0u, 1u, 37u, 99u}) {
    std::array<std::byte, 400> room{};
    BitWriter out(room);
    queue.write(out, first, 100 - first);
    BitReader in(room);
    auto bytes = queue.before(first);
    for (auto frame = first; frame < 100; ++frame) {
      unpack(in, bytes);
      CHECK(bytes == queue[frame]);
    }
    CHECK_FALSE(in.has_failed());
  }
  for (int i = 0; i < 100; ++i) queue.push(wire_of<Pad>(bytes_of(Pad{})));
  CHECK_FALSE(queue.has(71));
  CHECK(queue.has(72));
  CHECK_FALSE(queue.has(200));
}

TEST_CASE("packet: what is written is read, completely or not at all") {
  Packet packet;
  packet.frame = 1000;
  packet.ahead = 130;
  packet.is_paused = true;
  packet.dropped = 5;
  packet.held = {990, 1003, 7};
  InputQueue<Pad, 128> queue;
  for (int i = 0; i < 12; ++i) {
    queue.push(wire_of<Pad>(bytes_of(Pad{static_cast<std::int16_t>(i), false})));
  }
  packet.runs[0] = {2, 3, 9, {}};
  packet.run_count = 1;
  packet.digests = {998, 2, {17, 18}};
  packet.fields = FieldDigests{997, 4096, 2, {1, 2, 3}};
  CHECK(packet.fields->width() == 256);

  std::array<std::byte, 300> room{};
  BitWriter out(std::span<std::byte>(room).subspan(PacketHeader::size));
  packet.write(out, 3,
               [&](auto& bits, const InputRun& run) { queue.write(bits, run.first, run.count); });
  const auto whole = std::span<std::byte>(room).first(PacketHeader::size + out.byte_count());
  PacketHeader{9}.seal(whole, 42);
  const auto header = PacketHeader::read(whole, 42);
  REQUIRE(header);
  CHECK(header->sender == 9);
  CHECK_FALSE(PacketHeader::read(whole, 43));

  const auto body = whole.subspan(PacketHeader::size);
  const auto read = Packet::read<Pad>(body, 3);
  REQUIRE(read);
  CHECK(read->frame == 1000);
  CHECK(read->ahead == 130);
  CHECK(read->is_paused);
  CHECK(read->dropped == 5);
  CHECK(read->held == packet.held);
  REQUIRE(read->run_count == 1);
  CHECK(read->runs[0].count == 9);
  CHECK(read->runs[0].first == 3);
  CHECK(read->digests.first == 998);
  CHECK(read->digests.values == packet.digests.values);
  REQUIRE(read->fields);
  CHECK(read->fields->values == packet.fields->values);
  CHECK_FALSE(read->join);
  CHECK_FALSE(read->slice);
  auto bits = read->runs[0].bits;
  auto input = queue.before(3);
  for (std::uint32_t frame = 3; frame < 12; ++frame) {
    unpack(bits, input);
    CHECK(input == queue[frame]);
  }

  for (std::size_t size = 0; size < body.size(); ++size) {
    CHECK_FALSE(Packet::read<Pad>(body.first(size), 3));
  }
  std::vector<std::byte> longer(body.begin(), body.end());
  longer.push_back({});
  CHECK_FALSE(Packet::read<Pad>(longer, 3));
  // Every bit of a sealed packet matters.
  for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
    std::vector<std::byte> changed(whole.begin(), whole.end());
    changed[bit / 8] ^= std::byte{1} << (bit % 8);
    CHECK_FALSE(PacketHeader::read(changed, 42));
  }
}

TEST_CASE("packet: terms, a late peer's messages and slices are read as written") {
  Packet packet;
  packet.terms = {0, 3, 255};
  packet.join = JoinState{7, true, false, 0, 2, 300, 4, 0x80000001u};
  std::array<std::byte, 20> bytes{};
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::byte>(37 * i);
  packet.slice = Slice{300, 500, 0x0123456789abcdefu, 24, 20, bytes, {}};
  for (const bool is_loaded : {false, true}) {
    packet.join->is_loaded = is_loaded;
    packet.join->start = is_loaded ? 99 : 0;
    std::array<std::byte, 200> room{};
    BitWriter out(room);
    packet.write(out, 3, [](auto&, const auto&) {});
    REQUIRE(out.has_room());
    CHECK(out.byte_count() <= Packet::slice_room + bytes.size() - PacketHeader::size);
    const auto body = std::span<const std::byte>(room).first(out.byte_count());
    const auto read = Packet::read<Pad>(body, 3);
    REQUIRE(read);
    CHECK(read->terms == packet.terms);
    REQUIRE(read->join);
    CHECK(read->join->life == 7);
    CHECK(read->join->wants_seat);
    CHECK(read->join->is_loaded == is_loaded);
    CHECK(read->join->start == packet.join->start);
    CHECK(read->join->source == (is_loaded ? 0 : 2));
    CHECK(read->join->frame == (is_loaded ? 0 : 300));
    CHECK(read->join->first == (is_loaded ? 0 : 4));
    CHECK(read->join->later == (is_loaded ? 0 : 0x80000001u));
    REQUIRE(read->slice);
    CHECK(read->slice->frame == 300);
    CHECK(read->slice->total == 500);
    CHECK(read->slice->digest == 0x0123456789abcdefu);
    CHECK(read->slice->index == 24);
    REQUIRE(read->slice->size == 20);
    auto bits = read->slice->bits;
    for (const auto byte : bytes) CHECK(static_cast<std::byte>(bits.number(8)) == byte);
    for (std::size_t size = 0; size < body.size(); ++size) {
      CHECK_FALSE(Packet::read<Pad>(body.first(size), 3));
    }
  }
}

TEST_CASE("transfer: slices come in any order, and other slices restart it") {
  Outgoing<1000, 100> out;
  for (std::size_t i = 0; i < 950; ++i) out.room()[i] = static_cast<std::byte>(i * i / 7);
  out.start(3, 5, 60, 950);
  CHECK(out.is_for(3, 5));
  CHECK_FALSE(out.is_for(3, 6));
  Incoming<1000, 100> in;
  // A slice as read from a packet.
  const auto sent = [](Slice slice) {
    static std::array<std::byte, 300> room;
    BitWriter bits(room);
    for (const auto byte : slice.bytes) bits.add(std::to_integer<std::uint64_t>(byte), 8);
    slice.bits = BitReader(room);
    return slice;
  };
  JoinState guest;
  std::size_t count = 0;
  for (; !in.is_whole() && count < 100; ++count) {
    in.describe(guest);
    const auto slice = out.next(guest);
    if (count % 3 != 1) {
      CHECK(in.take(sent(slice)));
      CHECK_FALSE(in.take(sent(slice)));
    }
  }
  CHECK(count <= 16);  // ten slices, a third of which was lost
  REQUIRE(in.bytes().size() == 950);
  CHECK(std::equal(in.bytes().begin(), in.bytes().end(), out.room().begin()));
  // Invalid slices, and one of another snapshot.
  auto slice = out.next(guest);
  const auto is_refused = [&](auto&& change) {
    auto other = slice;
    change(other);
    CHECK_FALSE(in.take(sent(other)));
    CHECK(in.is_whole());
    Incoming<1000, 100> fresh;
    CHECK_FALSE(fresh.take(sent(other)));
  };
  is_refused([](Slice& s) { s.total = 0; });
  is_refused([](Slice& s) { s.total = 1001; });
  is_refused([](Slice& s) { s.index = 10; });
  is_refused([](Slice& s) { s.index = 0xffffffffu; });
  is_refused([](Slice& s) { --s.size; });
  slice.digest ^= 1;
  CHECK(in.take(sent(slice)));
  CHECK_FALSE(in.is_whole());
}

TEST_CASE("packet: bytes are the same on every machine") {
  Packet packet;
  packet.frame = 0x01020304;
  packet.ahead = 128;
  packet.held = {0x01020304, 0x01020306};
  packet.digests = {0x01020303, 1, {0xa1b2c3d4}};
  std::array<std::byte, 64> room{};
  BitWriter out(std::span<std::byte>(room).subspan(PacketHeader::size));
  packet.write(out, 2, [](auto&, const auto&) {});
  const auto whole = std::span<std::byte>(room).first(PacketHeader::size + out.byte_count());
  PacketHeader{1}.seal(whole, 0x1122334455667788u);
  std::string hex;
  for (const auto byte : whole) {
    constexpr auto digits = "0123456789abcdef";
    hex += digits[std::to_integer<unsigned>(byte) / 16];
    hex += digits[std::to_integer<unsigned>(byte) % 16];
  }
  CHECK(hex == "646c02017d8ae1d84ce397060403020180004104f5b06c28");
}
