// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "detent/cull/lanes.hpp"
#include "detent/cull/quantized_box.hpp"

namespace detent::detail {

inline constexpr std::uint32_t nowhere = 0xffffffffu;

/// The most levels of a tree: with three children or more per node, enough for 2^32 objects.
inline constexpr std::size_t tree_depth = 21;

/// A node of the broad phase: up to eight boxes, side by side so that one loop tests them all.
template <Scalar S, int N>
struct alignas(64) TreeNode {
  static constexpr std::size_t width = 8;
  using Box = QuantizedBox<S, N>;
  using Lane = std::array<typename Box::Coordinate, width>;
  using Mask = std::uint32_t;  // bit i for box i

  std::array<Lane, static_cast<std::size_t>(N)> low;
  std::array<Lane, static_cast<std::size_t>(N)> high;
  std::array<std::uint32_t, width> child;  // an object in a leaf, else a node
  std::uint32_t parent = nowhere;
  std::uint16_t level = 0;  // 0 for a leaf
  std::uint16_t count = 0;

  constexpr TreeNode() noexcept {
    for (std::size_t i = 0; i < width; ++i) clear(i);
  }

  /// Sets an empty box, which overlaps nothing and does not enlarge `bounds`.
  constexpr void clear(std::size_t i) noexcept {
    for (auto& lane : low) lane[i] = Grid<S>::beyond;
    for (auto& lane : high) lane[i] = -Grid<S>::beyond;
    child[i] = nowhere;
  }
  constexpr void set(std::size_t i, const Box& box) noexcept {
    for (std::size_t axis = 0; axis < low.size(); ++axis) {
      low[axis][i] = box.low[axis];
      high[axis][i] = box.high[axis];
    }
  }
  [[nodiscard]] constexpr Box box(std::size_t i) const noexcept {
    Box result;
    for (std::size_t axis = 0; axis < low.size(); ++axis) {
      result.low[axis] = low[axis][i];
      result.high[axis] = high[axis][i];
    }
    return result;
  }
  [[nodiscard]] constexpr std::size_t place_of(std::uint32_t id) const noexcept {
    std::size_t i = 0;
    while (child[i] != id) ++i;
    return i;
  }

  /// The box around all boxes.
  [[nodiscard]] constexpr Box bounds() const noexcept {
    Box result;
    for (std::size_t axis = 0; axis < low.size(); ++axis) {
      const auto *const lows = low[axis].data(), *const highs = high[axis].data();
      auto least = lows[0], most = highs[0];
      for (std::size_t i = 1; i < width; ++i) {
        least = lows[i] < least ? lows[i] : least;
        most = highs[i] > most ? highs[i] : most;
      }
      result.low[axis] = least;
      result.high[axis] = most;
    }
    return result;
  }

  /// Which boxes overlap `box`.
  [[nodiscard]] constexpr Mask meeting(const Box& box) const noexcept {
    using Coordinate = typename Box::Coordinate;
    const Mask used = (1u << count) - 1;  // a box that is everywhere overlaps empty boxes too
    if (__builtin_is_constant_evaluated()) return meeting<ArrayLanes<Coordinate>>(box) & used;
    return meeting<ComparedLanes<Coordinate>>(box) & used;
  }
  /// Writes the children whose bits are set, in order, and returns how many there are. `to` has room
  /// for eight, of which the others are unspecified.
  constexpr std::size_t pack_children(Mask mask, std::uint32_t* to) const noexcept {
    if (__builtin_is_constant_evaluated()) return ArrayLanes<std::uint32_t>(child).pack(mask, to);
    return ComparedLanes<std::uint32_t>(child).pack(mask, to);
  }
  /// Which boxes overlap `box`, with one type of lanes, for all eight entries.
  template <class Lanes>
  [[nodiscard]] constexpr Mask meeting(const Box& box) const noexcept {
    typename Lanes::Marks apart;
    for (std::size_t axis = 0; axis < low.size(); ++axis) {
      apart.add_above(Lanes(low[axis]), Lanes(box.high[axis]));
      apart.add_above(Lanes(box.low[axis]), Lanes(high[axis]));
    }
    return apart.unmarked();
  }
};

/// One entry: a child and its box.
template <Scalar S, int N>
struct TreeEntry {
  QuantizedBox<S, N> box;
  std::uint32_t child = nowhere;
};

}  // namespace detent::detail
