// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "detent/lockstep/input_codec.hpp"
#include "detent/lockstep/timeline.hpp"
#include "detent/number/digest.hpp"
#include "detent/scene/world.hpp"
#include "detent/version.hpp"

// Replays: the first snapshot and the inputs of a match, with periodic digests of the world.
//   head:  "DTNR", format 2 bytes, results_version 4, players 1, bytes of an input 2, of the kind 1
//          and of the snapshot 4, all little endian; kind; snapshot; XXH64 of all that, 8
//   block: bytes of inputs 2, frames 1, digest of the world after the last of them 8, inputs as
//        bits; the low half of XXH64 of all that, seeded by the digest of the previous head or
//        block, 4
// A file grows by whole blocks. A block cut off by a crash is skipped; everything before it is
// read.

namespace detent {

/// The properties that a replay stores before its frames.
struct ReplayInfo {
  std::string_view kind;  // the kind of world: which game can simulate it; at most 255 bytes
  std::size_t players = 2;
  std::uint32_t results = static_cast<std::uint32_t>(results_version);
  std::span<const std::byte> snapshot;  // of the world before the first frame
};

namespace detail {

struct ReplayFormat {
  static constexpr std::uint32_t magic = 0x524e5444u;  // "DTNR"
  static constexpr std::uint16_t version = 1;
  static constexpr std::size_t head = 18, block_head = 11, sum = 4;
  static constexpr std::size_t capacity = 4096;  // bytes of inputs in a block
};

[[nodiscard]] constexpr std::uint64_t digest_from(std::uint64_t seed,
                                                  std::span<const std::byte> bytes) noexcept {
  Digest digest(seed);
  digest.add_bytes(bytes);
  return digest.value();
}

}  // namespace detail

/// Writes a replay while a match is played, by calls of sink(bytes), each with bytes to append.
///
///     ReplayWriter<Pad> replay;
///     replay.begin({.kind = "game 1", .snapshot = bytes}, sink);
///     // for every frame before session.final_frame():
///     replay.add(*session.inputs(frame), *session.result(frame), sink);
///
/// A frame with unchanged inputs takes one bit per player and one more; a block adds 15 bytes.
///
/// (tests/lockstep/replay.test.cpp)
template <class Input, std::size_t Players = 8>
class ReplayWriter : detail::ReplayFormat {
 public:
  /// A block ends, with a digest, after `every` frames, 1 to 255, or when its storage is full.
  explicit constexpr ReplayWriter(std::size_t every = 60) noexcept
      : every_(std::clamp(every, std::size_t{1}, std::size_t{255})) {}

  /// Writes the head.
  template <class Sink>
  constexpr void begin(const ReplayInfo& info, const Sink& sink) {
    *this = ReplayWriter(every_);
    players_ = (std::min)(info.players, Players);
    const auto kind = info.kind.substr(0, 255);
    std::array<std::byte, head + 255> bytes{};
    detail::store_word(bytes.data(), magic);
    detail::store_word(bytes.data() + 4, version);
    detail::store_word(bytes.data() + 6, info.results);
    detail::store_word(bytes.data() + 10, static_cast<std::uint8_t>(players_));
    detail::store_word(bytes.data() + 11, static_cast<std::uint16_t>(InputCodec<Input>::size));
    detail::store_word(bytes.data() + 13, static_cast<std::uint8_t>(kind.size()));
    detail::store_word(bytes.data() + 14, static_cast<std::uint32_t>(info.snapshot.size()));
    for (std::size_t i = 0; i < kind.size(); ++i) bytes[head + i] = static_cast<std::byte>(kind[i]);
    const auto front = std::span<const std::byte>(bytes).first(head + kind.size());
    Digest digest;
    digest.add_bytes(front);
    digest.add_bytes(info.snapshot);
    seed_ = digest.value();
    std::array<std::byte, 8> tail{};
    detail::store_word(tail.data(), seed_);
    sink(front);
    sink(info.snapshot);
    sink(std::span<const std::byte>(tail));
  }

  /// Adds a final frame, with the world after it.
  template <RollbackWorld World, class Sink>
  constexpr void add(const FrameInputs<Input, Players>& inputs, const World& world,
                     const Sink& sink) {
    detail::BitWriter out(std::span<std::byte>(block_).subspan(block_head, capacity), bits_);
    std::uint32_t present = 0;
    for (std::size_t i = 0; i < players_; ++i) present |= inputs.is_in(i) ? 1u << i : 0u;
    out.add_flag(present != present_);
    if (present != present_) out.add(present, static_cast<int>(players_));
    present_ = present;
    for (std::size_t i = 0; i < players_; ++i) {
      const auto input = detail::bytes_of(inputs[i]);
      detail::pack(out, input, before_[i]);
      before_[i] = input;
    }
    bits_ = out.bit_count();
    if (++frames_ == every_ || bits_ + worst_frame > 8 * capacity) end(world, sink);
  }

  /// Ends a block now, with the world after its last frame. Call it at least at the end of a match.
  template <RollbackWorld World, class Sink>
  constexpr void end(const World& world, const Sink& sink) {
    if (frames_ == 0) return;
    const auto size = (bits_ + 7) / 8;
    detail::store_word(block_.data(), static_cast<std::uint16_t>(size));
    detail::store_word(block_.data() + 2, static_cast<std::uint8_t>(frames_));
    detail::store_word(block_.data() + 3, detent::world_digest(world));
    seed_ = detail::digest_from(seed_, std::span<const std::byte>(block_).first(block_head + size));
    detail::store_word(block_.data() + block_head + size, static_cast<std::uint32_t>(seed_));
    sink(std::span<const std::byte>(block_.data(), block_head + size + sum));
    frames_ = bits_ = 0;
  }

 private:
  static constexpr std::size_t worst_frame =
      1 + Players + Players * (1 + 9 * InputCodec<Input>::size);
  static_assert(worst_frame <= 8 * capacity, "one frame of inputs must fit in a block");

  std::size_t every_;
  std::size_t players_ = 0, frames_ = 0, bits_ = 0;
  std::uint32_t present_ = 0;
  std::uint64_t seed_ = 0;
  std::array<detail::InputBytes<Input>, Players> before_{};
  std::array<std::byte, block_head + capacity + sum> block_{};
};

/// Whether bytes are a replay, and how far they can be read.
enum class ReplayState : std::uint8_t {
  whole,          // every byte was read
  cut,            // the last block is incomplete: its writer was stopped
  corrupted,      // a byte has changed; the frames before it were read
  no_replay,      // not a replay of this format, or its head is incomplete
  other_inputs,   // of a different number of players or size of inputs
  other_results,  // recorded with a different `results_version`
};

/// Reads a replay from bytes that must outlive it. It accepts any bytes.
template <class Input, std::size_t Players = 8>
class ReplayReader : detail::ReplayFormat {
 public:
  /// Reads the head.
  explicit constexpr ReplayReader(std::span<const std::byte> bytes) noexcept : bytes_(bytes) {
    state_ = read_head();
  }

  [[nodiscard]] constexpr ReplayState state() const noexcept { return state_; }
  [[nodiscard]] constexpr std::span<const std::byte> snapshot() const noexcept { return snapshot_; }
  [[nodiscard]] constexpr std::size_t players() const noexcept { return players_; }
  /// Whether the replay is of this kind of world.
  [[nodiscard]] constexpr bool is_kind(std::string_view kind) const noexcept {
    if (kind.size() != kind_.size()) return false;
    for (std::size_t i = 0; i < kind.size(); ++i) {
      if (kind_[i] != static_cast<std::byte>(kind[i])) return false;
    }
    return true;
  }

  /// Calls visit(inputs) for each frame of the next block, in order. Returns the digest of the
  /// world after the last of them, or nothing at the end: see `state`.
  template <class Visit>
  [[nodiscard]] constexpr std::optional<std::uint64_t> next_block(const Visit& visit) {
    if (state_ != ReplayState::whole || left().empty()) return std::nullopt;
    const auto block = left();
    if (block.size() < block_head + sum) return stop(ReplayState::cut);
    const auto size = detail::load_word<std::uint16_t>(block.data());
    if (size > capacity) return stop(ReplayState::corrupted);
    if (block.size() < block_head + size + sum) return stop(ReplayState::cut);
    const auto seed = detail::digest_from(seed_, block.first(block_head + size));
    if (static_cast<std::uint32_t>(seed) !=
        detail::load_word<std::uint32_t>(block.data() + block_head + size)) {
      return stop(ReplayState::corrupted);
    }
    // The checksum may be forged: missing bits read as unchanged inputs.
    detail::BitReader in(block.subspan(block_head, size));
    const auto frames = detail::load_word<std::uint8_t>(block.data() + 2);
    for (std::uint32_t i = 0; i < frames; ++i) visit(next_frame(in));
    if (!in.is_at_end()) return stop(ReplayState::corrupted);
    position_ += block_head + size + sum;
    seed_ = seed;
    return detail::load_word<std::uint64_t>(block.data() + 3);
  }

 private:
  [[nodiscard]] constexpr std::span<const std::byte> left() const noexcept {
    return bytes_.subspan(position_);
  }
  constexpr std::optional<std::uint64_t> stop(ReplayState state) noexcept {
    state_ = state;
    return std::nullopt;
  }

  [[nodiscard]] constexpr ReplayState read_head() noexcept {
    if (bytes_.size() < head + 8 || detail::load_word<std::uint32_t>(bytes_.data()) != magic ||
        detail::load_word<std::uint16_t>(bytes_.data() + 4) != version) {
      return ReplayState::no_replay;
    }
    const std::size_t kind = detail::load_word<std::uint8_t>(bytes_.data() + 13);
    const std::size_t snapshot = detail::load_word<std::uint32_t>(bytes_.data() + 14);
    if (bytes_.size() - head - 8 < kind || bytes_.size() - head - 8 - kind < snapshot) {
      return ReplayState::no_replay;
    }
    position_ = head + kind + snapshot;
    seed_ = detail::digest_from(0, bytes_.first(position_));
    if (seed_ != detail::load_word<std::uint64_t>(bytes_.data() + position_)) {
      return ReplayState::no_replay;
    }
    position_ += 8;
    kind_ = bytes_.subspan(head, kind);
    snapshot_ = bytes_.subspan(head + kind, snapshot);
    players_ = detail::load_word<std::uint8_t>(bytes_.data() + 10);
    if (players_ == 0 || players_ > Players ||
        detail::load_word<std::uint16_t>(bytes_.data() + 11) != InputCodec<Input>::size) {
      return ReplayState::other_inputs;
    }
    return detail::load_word<std::uint32_t>(bytes_.data() + 6) == results_version
               ? ReplayState::whole
               : ReplayState::other_results;
  }

  [[nodiscard]] constexpr FrameInputs<Input, Players> next_frame(detail::BitReader& in) noexcept {
    FrameInputs<Input, Players> inputs(frame_++, players_);
    if (in.flag()) present_ = static_cast<std::uint32_t>(in.number(static_cast<int>(players_)));
    for (std::size_t i = 0; i < players_; ++i) {
      detail::unpack(in, before_[i]);
      if (((present_ >> i) & 1u) != 0) inputs.set(i, InputCodec<Input>::read(before_[i].data()));
    }
    return inputs;
  }

  std::span<const std::byte> bytes_, kind_, snapshot_;
  std::size_t position_ = 0, players_ = 0;
  std::uint32_t frame_ = 0, present_ = 0;
  std::uint64_t seed_ = 0;
  std::array<detail::InputBytes<Input>, Players> before_{};
  ReplayState state_;
};

/// The result of simulating a replay again.
struct ReplayCheck {
  ReplayState state{};  // of the replay: `cut` and `corrupted` ones are checked up to that point
  std::uint32_t frames = 0;  // simulated
  std::uint32_t equal = 0;   // the first `equal` frames match the recorded digest after them
  bool is_equal = true;      // if not, the first frame that differs is one of `equal` to `frames`
};

/// Simulates a replay from a world that the caller restored from its snapshot, up to the first
/// digest that differs. If recorded with `every` = 1, that identifies the frame.
template <class Input, std::size_t Players = 8, RollbackWorld World, class Simulate>
[[nodiscard]] constexpr ReplayCheck check_replay(ReplayReader<Input, Players> replay, World world,
                                                 const Simulate& simulate) {
  ReplayCheck check;
  const auto one = [&](const FrameInputs<Input, Players>& inputs) {
    simulate(world, inputs);
    ++check.frames;
  };
  while (const auto digest = replay.next_block(one)) {
    check.is_equal = detent::world_digest(world) == *digest;
    if (!check.is_equal) break;
    check.equal = check.frames;
  }
  check.state = replay.state();
  return check;
}

}  // namespace detent
