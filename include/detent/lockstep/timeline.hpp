// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "detent/lockstep/input_codec.hpp"
#include "detent/number/assert.hpp"

namespace detent {

/// The inputs of one frame, as passed to a simulation: equal on all peers once final.
template <class Input, std::size_t Players>
class FrameInputs {
 public:
  /// Inputs of a frame without players, until they are set.
  ///
  /// domain: at most `Players` players, here and below
  constexpr FrameInputs(std::uint32_t frame, std::size_t players) noexcept
      : frame_(frame), players_(players) {
    DETENT_ASSERT(players <= Players);
  }

  /// The number of the frame, from 0.
  [[nodiscard]] constexpr std::uint32_t frame() const noexcept { return frame_; }
  /// The number of players, including those who left.
  [[nodiscard]] constexpr std::size_t size() const noexcept { return players_; }
  /// A player's input; `Input{}` after the player left.
  [[nodiscard]] constexpr const Input& operator[](std::size_t player) const noexcept {
    DETENT_ASSERT(player < Players);
    return inputs_[player];
  }
  /// Whether the player still plays.
  [[nodiscard]] constexpr bool is_in(std::size_t player) const noexcept {
    DETENT_ASSERT(player < Players);
    return ((present_ >> player) & 1u) != 0;
  }
  constexpr void set(std::size_t player, const Input& input) noexcept {
    DETENT_ASSERT(player < Players);
    inputs_[player] = input;
    present_ |= 1u << player;
  }

 private:
  std::array<Input, Players> inputs_{};
  std::uint32_t frame_;
  std::size_t players_;
  std::uint32_t present_ = 0;
};

namespace detail {

template <class T, std::size_t... I>
[[nodiscard]] constexpr std::array<T, sizeof...(I)> copies(const T& value,
                                                           std::index_sequence<I...>) {
  return {((void)I, value)...};
}

/// The worlds before the last frames and after the last one, with their inputs.
template <class World, class Input, std::size_t Players, std::size_t Kept>
class Timeline {
 public:
  using Bytes = InputBytes<Input>;
  using Used = std::array<Bytes, Players>;

  explicit constexpr Timeline(const World& start)
      : worlds_(copies(start, std::make_index_sequence<Kept>())) {}

  /// The number of simulated frames.
  [[nodiscard]] constexpr std::uint32_t done() const noexcept { return done_; }
  [[nodiscard]] constexpr const World& world() const noexcept { return worlds_[done_ % Kept]; }
  /// Whether the world after a frame is still stored.
  [[nodiscard]] constexpr bool has_result(std::uint32_t frame) const noexcept {
    return frame < done_ && latest_ - frame <= Kept && frame + 1 >= start_;
  }
  [[nodiscard]] constexpr const World& result(std::uint32_t frame) const noexcept {
    return worlds_[(frame + 1) % Kept];
  }
  [[nodiscard]] constexpr const Used& used(std::uint32_t frame) const noexcept {
    return used_[frame % Kept];
  }

  /// Starts before `frame` with the world that load(world) makes; load returns whether it
  /// succeeded.
  template <class Load>
  [[nodiscard]] constexpr bool start(std::uint32_t frame, const Load& load) {
    if (!load(worlds_[frame % Kept])) return false;
    start_ = done_ = latest_ = frame;
    return true;
  }

  /// Goes back to before `frame`, if it has been simulated.
  constexpr void go_back(std::uint32_t frame) noexcept { done_ = (std::min)(done_, frame); }

  /// Opens the next frame: simulate `opened` with the inputs of `bytes`, then close it.
  constexpr void open(const Used& bytes) {
    opened() = worlds_[done_ % Kept];
    used_[done_ % Kept] = bytes;
    is_open_ = true;
  }
  [[nodiscard]] constexpr bool is_open() const noexcept { return is_open_; }
  [[nodiscard]] constexpr World& opened() noexcept { return worlds_[(done_ + 1) % Kept]; }
  constexpr void close() noexcept {
    is_open_ = false;
    latest_ = (std::max)(latest_, ++done_);
  }
  /// Discards the open frame: its inputs may have changed.
  constexpr void discard() noexcept { is_open_ = false; }

 private:
  std::array<World, Kept> worlds_;  // before frame i at i modulo Kept
  std::array<Used, Kept> used_{};
  std::uint32_t done_ = 0, latest_ = 0, start_ = 0;
  bool is_open_ = false;
};

}  // namespace detail

}  // namespace detent
