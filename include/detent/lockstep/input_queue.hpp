// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "detent/lockstep/input_codec.hpp"

namespace detent::detail {

/// The inputs of one player, frame after frame without a gap; the last `History` are kept. An input
/// never changes once it is here.
template <class Input, std::size_t History>
class InputQueue {
 public:
  using Bytes = InputBytes<Input>;

  /// The number of frames whose inputs have been added: the next one is for frame `count()`.
  [[nodiscard]] constexpr std::uint32_t count() const noexcept { return count_; }
  [[nodiscard]] constexpr bool has(std::uint32_t frame) const noexcept {
    return frame < count_ && count_ - frame <= History;
  }
  /// The input of a frame; of one that is not kept, some other.
  [[nodiscard]] constexpr const Bytes& operator[](std::uint32_t frame) const noexcept {
    return inputs_[frame % History];
  }
  /// The input before `frame`; before the first one `Input{}`. It must be kept: `has_before`.
  [[nodiscard]] constexpr Bytes before(std::uint32_t frame) const noexcept {
    return frame == 0 ? bytes_of(Input{}) : inputs_[(frame - 1) % History];
  }
  [[nodiscard]] constexpr bool has_before(std::uint32_t frame) const noexcept {
    return frame == 0 || has(frame - 1);
  }
  /// What a frame without input is predicted to have: the last input again.
  [[nodiscard]] constexpr Bytes last() const noexcept { return before(count_); }

  constexpr void push(const Bytes& input) noexcept { inputs_[count_++ % History] = input; }

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
};

}  // namespace detent::detail
