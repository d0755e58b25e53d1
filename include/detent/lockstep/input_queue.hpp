// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "detent/lockstep/input_codec.hpp"

namespace detent::detail {

/// An extra byte of a player's input: nothing, or the seat that it gives to a guest. In a frame
/// without the player it is `absent`.
inline constexpr std::byte no_word{0}, absent{0xff};

/// An input as stored and sent: its bytes, and that extra byte.
template <class Input>
using WireInput = std::array<std::byte, InputCodec<Input>::size + 1>;

template <class Input>
[[nodiscard]] constexpr WireInput<Input> wire_of(const InputBytes<Input>& input,
                                                 std::byte word = no_word) noexcept {
  WireInput<Input> wire{};
  std::copy(input.begin(), input.end(), wire.begin());
  wire.back() = word;
  return wire;
}
template <class Input>
[[nodiscard]] constexpr InputBytes<Input> input_of(const WireInput<Input>& wire) noexcept {
  InputBytes<Input> input{};
  std::copy(wire.begin(), wire.end() - 1, input.begin());
  return input;
}
/// The input that any bytes decode to: equal for equal inputs.
template <class Input>
[[nodiscard]] constexpr WireInput<Input> canonical_wire(const WireInput<Input>& wire,
                                                        std::size_t players) noexcept {
  const bool is_seat = std::to_integer<std::size_t>(wire.back()) <= players;
  return wire_of<Input>(canonical<Input>(input_of<Input>(wire)), is_seat ? wire.back() : no_word);
}

/// The inputs of one player, frame after frame without a gap; the last `History` are stored. A
/// stored input never changes.
template <class Input, std::size_t History>
class InputQueue {
 public:
  using Bytes = WireInput<Input>;

  /// The number of frames whose inputs have been added: the next one is for frame `count()`.
  [[nodiscard]] constexpr std::uint32_t count() const noexcept { return count_; }
  [[nodiscard]] constexpr bool has(std::uint32_t frame) const noexcept {
    return frame < count_ && count_ - frame <= History && frame >= first_;
  }
  /// The input of a frame; if it is no longer stored, some other input.
  [[nodiscard]] constexpr const Bytes& operator[](std::uint32_t frame) const noexcept {
    return inputs_[frame % History];
  }
  /// The input before `frame`; before the first one `Input{}`. It must be stored: `has_before`.
  [[nodiscard]] constexpr Bytes before(std::uint32_t frame) const noexcept {
    return frame == 0 ? wire_of<Input>(bytes_of(Input{})) : inputs_[(frame - 1) % History];
  }
  [[nodiscard]] constexpr bool has_before(std::uint32_t frame) const noexcept {
    return frame == 0 ? first_ == 0 : has(frame - 1);
  }
  /// The prediction for a frame without input: the last input again.
  [[nodiscard]] constexpr Bytes last() const noexcept { return before(count_); }

  constexpr void push(const Bytes& input) noexcept { inputs_[count_++ % History] = input; }
  /// Adds frames without this player until `frame` is the next.
  constexpr void skip_to(std::uint32_t frame) noexcept {
    const auto kept = frame - (std::min)(frame, static_cast<std::uint32_t>(History));
    count_ = (std::max)(count_, kept);
    while (count_ < frame) push(wire_of<Input>(bytes_of(Input{}), absent));
  }
  /// Begins at `frame`, with the input before it.
  constexpr void start(std::uint32_t frame, const Bytes& before) noexcept {
    count_ = frame;
    first_ = frame - (frame != 0 ? 1 : 0);
    if (frame != 0) inputs_[(frame - 1) % History] = before;
  }
  /// Whether the player is known to be absent in a frame.
  [[nodiscard]] constexpr bool is_absent(std::uint32_t frame) const noexcept {
    return has(frame) && (*this)[frame].back() == absent;
  }

  /// How many inputs from frame `first` on fit in `bits` bits, at most `limit`. For this and `write`
  /// `has_before(first)` must hold.
  [[nodiscard]] constexpr std::uint32_t fitting(std::uint32_t first, std::uint32_t limit,
                                                std::size_t bits) const noexcept {
    const auto end = (std::min)(count_, first + limit);
    Bytes previous = before(first);
    BitWriter measure({});
    for (auto frame = first; frame < end; ++frame) {
      pack(measure, (*this)[frame], previous);
      if (measure.bit_count() > bits) return frame - first;
      previous = (*this)[frame];
    }
    return end - first;
  }
  constexpr void write(BitWriter& out, std::uint32_t first, std::uint32_t count) const noexcept {
    Bytes previous = before(first);
    for (auto frame = first; frame < first + count; ++frame) {
      pack(out, (*this)[frame], previous);
      previous = (*this)[frame];
    }
  }

 private:
  std::array<Bytes, History> inputs_{};
  std::uint32_t count_ = 0;
  std::uint32_t first_ = 0;  // inputs before this frame were never here
};

}  // namespace detent::detail
