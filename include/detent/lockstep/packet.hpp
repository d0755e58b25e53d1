// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "detent/lockstep/input_codec.hpp"
#include "detent/number/digest.hpp"

// Packets of a session. Twelve bytes of header, little endian:
//   magic 2, version 1, sender 1, checksum 8: XXH64, seeded by the match, of all the rest
// then bits: `Packet::write` is the list. A packet is read whole or not at all. The checksum
// detects packets of other matches and damaged ones; it is not authentication, which is up to the
// transport.

namespace detent::detail {

inline constexpr std::size_t most_players = 8;
inline constexpr std::size_t most_peers = 16;

struct PacketHeader {
  static constexpr std::uint16_t right_magic = 0x6c64;  // "dl"
  static constexpr std::uint8_t right_version = 2;
  static constexpr std::size_t size = 12;

  std::size_t sender = 0;

  /// Completes a packet whose other bytes are written.
  constexpr void seal(std::span<std::byte> packet, std::uint64_t match) const noexcept {
    store_word(packet.data(), right_magic);
    store_word(packet.data() + 2, right_version);
    store_word(packet.data() + 3, static_cast<std::uint8_t>(sender));
    store_word(packet.data() + 4, checksum(packet, match));
  }
  [[nodiscard]] static constexpr std::optional<PacketHeader> read(std::span<const std::byte> packet,
                                                                  std::uint64_t match) noexcept {
    if (packet.size() < size) return std::nullopt;
    if (load_word<std::uint16_t>(packet.data()) != right_magic ||
        load_word<std::uint8_t>(packet.data() + 2) != right_version ||
        load_word<std::uint64_t>(packet.data() + 4) != checksum(packet, match)) {
      return std::nullopt;
    }
    return PacketHeader{load_word<std::uint8_t>(packet.data() + 3)};
  }

 private:
  [[nodiscard]] static constexpr std::uint64_t checksum(std::span<const std::byte> packet,
                                                        std::uint64_t match) noexcept {
    Digest digest(match);
    digest.add_bytes(packet.first(4));
    digest.add_bytes(packet.subspan(size));
    return digest.value();
  }
};

/// Consecutive inputs of a player, still packed.
struct InputRun {
  static constexpr std::uint32_t most = 127;

  std::size_t player = 0;
  std::uint32_t first = 0, count = 0;
  BitReader bits;  // at the first input
};

/// Chained digests of consecutive frames.
struct DigestRun {
  static constexpr std::uint32_t most = 32;

  std::uint32_t first = 0, count = 0;
  std::array<std::uint32_t, most> values{};
};

/// Digests of a frame's first fields, up to 16 ends: a step of the search for the field that
/// differs.
struct FieldDigests {
  static constexpr std::size_t ways = 16;
  static constexpr int levels = 5;  // for up to 16^5 fields

  std::uint32_t frame = 0;  // the frame whose result differs
  std::uint32_t low = 0;    // the first `low` fields are equal
  int level = 0;
  std::array<std::uint32_t, ways> values{};

  /// The number of fields between two ends.
  [[nodiscard]] constexpr std::uint32_t width() const noexcept {
    return std::uint32_t{1} << (4 * (levels - 1 - level));
  }
};

/// The state that a late or returning peer sends about itself.
struct JoinState {
  std::uint32_t life = 0;   // greater than in its earlier sessions
  bool wants_seat = false;  // it wants a seat and has none
  bool is_loaded = false;   // it has the world before frame `start`; if not, it requests one:
  std::uint32_t start = 0;
  std::size_t source = 0;   // the player from which it requests a snapshot
  std::uint32_t frame = 0;  // of the snapshot whose slices it has
  std::uint32_t first = 0;  // it has all slices before this one
  std::uint32_t later = 0;  // which of the 32 slices after `first` it has, a bit each
};

/// A part of a snapshot.
struct Slice {
  std::uint32_t frame = 0;   // the snapshot is of the match before this frame
  std::uint32_t total = 0;   // bytes of the snapshot
  std::uint64_t digest = 0;  // XXH64 of the snapshot
  std::uint32_t index = 0, size = 0;
  std::span<const std::byte> bytes;  // of a slice to send
  BitReader bits;                    // of a slice that was received
};

/// The state of its sender.
struct Packet {
  std::uint32_t frame = 0;  // the frame that it simulates next
  std::uint32_t ahead = 0;  // how far it believes to be ahead of the receiver, plus 128
  bool is_paused = false;
  std::uint32_t dropped = 0;                       // the players that it dropped, one bit each
  std::array<std::uint32_t, most_players> held{};  // how many inputs of each player it holds
  std::array<InputRun, most_players> runs{};
  std::size_t run_count = 0;
  DigestRun digests;
  std::optional<FieldDigests> fields;
  std::array<std::uint8_t, most_players> terms{};  // how often each seat was reassigned
  std::optional<JoinState> join;
  std::optional<Slice> slice;

  /// The most bytes of a packet with a slice but without inputs, excluding the slice.
  static constexpr std::size_t slice_room = 160;

  /// Writes everything; `write_run(out, run)` appends the inputs of a run.
  template <class WriteRun>
  constexpr void write(BitWriter& out, std::size_t players,
                       const WriteRun& write_run) const noexcept {
    out.add(frame, 32);
    out.add(ahead, 8);
    out.add_flag(is_paused);
    out.add_flag(dropped != 0);
    if (dropped != 0) out.add(dropped, static_cast<int>(players));
    for (std::size_t i = 0; i < players; ++i) out.add_difference(held[i], frame);
    out.add_short(static_cast<std::uint32_t>(run_count));
    for (std::size_t i = 0; i < run_count; ++i) {
      out.add(runs[i].player, 3);
      out.add_difference(runs[i].first, frame);
      out.add(runs[i].count, 7);
      write_run(out, runs[i]);
    }
    out.add_short(digests.count);
    if (digests.count > 0) out.add_difference(digests.first, frame);
    for (std::uint32_t i = 0; i < digests.count; ++i) out.add(digests.values[i], 32);
    out.add_flag(fields.has_value());
    if (fields) {
      out.add(fields->frame, 32);
      out.add(fields->low, 32);
      out.add(static_cast<std::uint64_t>(fields->level), 3);
      for (const auto value : fields->values) out.add(value, 32);
    }
    const bool has_terms = terms != decltype(terms){};
    const bool has_more = has_terms || join || slice;
    out.add_flag(has_more);
    if (!has_more) return;
    out.add_flag(has_terms);
    for (std::size_t i = 0; has_terms && i < players; ++i) out.add(terms[i], 8);
    out.add_flag(join.has_value());
    if (join) write(out, *join);
    out.add_flag(slice.has_value());
    if (slice) write(out, *slice);
  }

  /// Reads the output of `write` after the header, or returns nothing.
  template <class Input>
  [[nodiscard]] static constexpr std::optional<Packet> read(std::span<const std::byte> bytes,
                                                            std::size_t players) noexcept {
    BitReader in(bytes);
    Packet packet;
    const auto below = [&](std::uint32_t number, std::uint32_t end) {
      if (number >= end) in.fail();
      return in.has_failed() ? 0 : number;
    };
    packet.frame = static_cast<std::uint32_t>(in.number(32));
    packet.ahead = static_cast<std::uint32_t>(in.number(8));
    packet.is_paused = in.flag();
    if (in.flag())
      packet.dropped = static_cast<std::uint32_t>(in.number(static_cast<int>(players)));
    for (std::size_t i = 0; i < players; ++i) packet.held[i] = in.difference(packet.frame);
    packet.run_count = below(in.short_number(), static_cast<std::uint32_t>(players) + 1);
    for (std::size_t i = 0; i < packet.run_count; ++i) {
      InputRun& run = packet.runs[i];
      run.player =
          below(static_cast<std::uint32_t>(in.number(3)), static_cast<std::uint32_t>(players));
      run.first = in.difference(packet.frame);
      run.count = static_cast<std::uint32_t>(in.number(7));
      run.bits = in;
      std::array<std::byte, InputCodec<Input>::size + 1> input{};
      for (std::uint32_t k = 0; k < run.count && !in.has_failed(); ++k) unpack(in, input);
    }
    packet.digests.count = below(in.short_number(), DigestRun::most + 1);
    if (packet.digests.count > 0) packet.digests.first = in.difference(packet.frame);
    for (std::uint32_t i = 0; i < packet.digests.count; ++i) {
      packet.digests.values[i] = static_cast<std::uint32_t>(in.number(32));
    }
    if (in.flag()) {
      FieldDigests& fields = packet.fields.emplace();
      fields.frame = static_cast<std::uint32_t>(in.number(32));
      fields.low = static_cast<std::uint32_t>(in.number(32));
      fields.level =
          static_cast<int>(below(static_cast<std::uint32_t>(in.number(3)), FieldDigests::levels));
      for (auto& value : fields.values) value = static_cast<std::uint32_t>(in.number(32));
    }
    if (in.flag()) read_more(in, packet, players);
    if (!in.is_at_end()) return std::nullopt;
    return packet;
  }

 private:
  static constexpr void write(BitWriter& out, const JoinState& join) noexcept {
    out.add(join.life, 32);
    out.add_flag(join.wants_seat);
    out.add_flag(join.is_loaded);
    if (join.is_loaded) return out.add(join.start, 32);
    out.add(join.source, 4);
    out.add(join.frame, 32);
    out.add(join.first, 32);
    out.add(join.later, 32);
  }
  static constexpr void write(BitWriter& out, const Slice& slice) noexcept {
    out.add(slice.frame, 32);
    out.add(slice.total, 32);
    out.add(slice.digest, 64);
    out.add(slice.index, 32);
    out.add(slice.size, 11);
    for (const auto byte : slice.bytes) out.add(std::to_integer<std::uint64_t>(byte), 8);
  }
  static constexpr void read_more(BitReader& in, Packet& packet, std::size_t players) noexcept {
    const auto word = [&] { return static_cast<std::uint32_t>(in.number(32)); };
    if (in.flag()) {
      for (std::size_t i = 0; i < players; ++i) {
        packet.terms[i] = static_cast<std::uint8_t>(in.number(8));
      }
    }
    if (in.flag()) {
      JoinState& join = packet.join.emplace();
      join.life = word();
      join.wants_seat = in.flag();
      join.is_loaded = in.flag();
      if (join.is_loaded) {
        join.start = word();
      } else {
        join.source = static_cast<std::size_t>(in.number(4));
        join.frame = word();
        join.first = word();
        join.later = word();
      }
    }
    if (in.flag()) {
      Slice& slice = packet.slice.emplace();
      slice.frame = word();
      slice.total = word();
      slice.digest = in.number(64);
      slice.index = word();
      slice.size = static_cast<std::uint32_t>(in.number(11));
      slice.bits = in;
      for (std::uint32_t i = 0; i < slice.size && !in.has_failed(); ++i) (void)in.number(8);
    }
  }
};

}  // namespace detent::detail
