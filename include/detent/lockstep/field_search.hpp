// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "detent/lockstep/input_codec.hpp"
#include "detent/lockstep/packet.hpp"
#include "detent/scene/difference.hpp"

namespace detent::detail {

/// The result of a frame and its inputs, as fields.
template <class World, class Inputs>
struct Evidence {
  const Inputs& inputs;
  const World& world;
};
template <class World, class Inputs, class F>
constexpr void for_each_field(const Evidence<World, Inputs>& evidence, const F& f) {
  f("input", evidence.inputs);  // input[player][byte]
  f("", evidence.world);
}

/// Finds the first field that differs between two peers that exchange only digests: both digest
/// their first fields up to 16 ends, and the first digest that differs gives the next 16 ends.
class FieldSearch {
 public:
  /// Sets the digests for the next packet.
  template <class Fields>
  constexpr void prepare(const Fields& fields) {
    next_ = digests_of(fields, next_.frame, next_.low, next_.level);
  }
  constexpr void start(std::uint32_t frame) noexcept { next_.frame = frame; }
  [[nodiscard]] constexpr const FieldDigests& next() const noexcept { return next_; }

  /// Takes a step of the other peer; returns the number of the field once it is known.
  template <class Fields>
  [[nodiscard]] constexpr std::optional<std::uint32_t> hear(const FieldDigests& theirs,
                                                            const Fields& fields) {
    if (is_found_ || theirs.frame != next_.frame || theirs.level < next_.level) return std::nullopt;
    const auto ours = digests_of(fields, theirs.frame, theirs.low, theirs.level);
    std::uint32_t way = 0;
    while (way < FieldDigests::ways && ours.values[way] == theirs.values[way]) ++way;
    if (way == FieldDigests::ways) return std::nullopt;
    const auto low = theirs.low + way * theirs.width();
    if (theirs.level == FieldDigests::levels - 1) {
      next_ = ours;  // the other peer needs it to finish
      is_found_ = true;
      return low;
    }
    next_ = digests_of(fields, theirs.frame, low, theirs.level + 1);
    return std::nullopt;
  }

 private:
  template <class Fields>
  [[nodiscard]] static constexpr FieldDigests digests_of(const Fields& fields, std::uint32_t frame,
                                                         std::uint32_t low, int level) {
    FieldDigests result{frame, low, level, {}};
    Digest digest;
    std::uint64_t seen = 0;
    std::size_t way = 0;
    const auto end = [&](std::size_t i) {
      return std::uint64_t{low} + (i + 1) * std::uint64_t{result.width()};
    };
    for_each_place(fields, detail::Fields::all, [&](const FieldPlace& place, std::uint64_t value) {
      if (way == FieldDigests::ways) return;
      for (const char c : place.name.view()) digest.add(c);
      digest.add(value);
      if (++seen == end(way)) result.values[way++] = static_cast<std::uint32_t>(digest.value());
    });
    for (; way < FieldDigests::ways; ++way) {
      result.values[way] = static_cast<std::uint32_t>(digest.value());
    }
    return result;
  }

  FieldDigests next_;
  bool is_found_ = false;
};

}  // namespace detent::detail
