// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include "detent/cull/lanes.hpp"
#include "detent/cull/long_lanes.hpp"
#include "detent/cull/tree/node.hpp"

// Groups the boxes of a tree so that the box around each group has a small surface.

namespace detent::detail {

template <Scalar S, int N>
[[nodiscard]] constexpr bool is_within(const QuantizedBox<S, N>& inner,
                                       const QuantizedBox<S, N>& outer) noexcept {
  bool is = true;
  for (std::size_t axis = 0; axis < inner.low.size(); ++axis) {
    is &= outer.low[axis] <= inner.low[axis] && inner.high[axis] <= outer.high[axis];
  }
  return is;
}

template <Scalar S, int N>
[[nodiscard]] constexpr QuantizedBox<S, N> hull_of(const QuantizedBox<S, N>& a,
                                                   const QuantizedBox<S, N>& b) noexcept {
  QuantizedBox<S, N> result;
  for (std::size_t axis = 0; axis < a.low.size(); ++axis) {
    result.low[axis] = (std::min)(a.low[axis], b.low[axis]);
    result.high[axis] = (std::max)(a.high[axis], b.high[axis]);
  }
  return result;
}

/// A measure of how often rays and boxes hit `box`: half its surface plus its extents; in 2D half
/// its perimeter.
template <Scalar S, int N>
[[nodiscard]] constexpr auto half_area(const QuantizedBox<S, N>& box) noexcept {
  const auto extent = [&](std::size_t i) { return Grid<S>::area_extent(box.low[i], box.high[i]); };
  if constexpr (N == 2) {
    return extent(0) + extent(1);
  } else {
    const auto x = extent(0), y = extent(1), z = extent(2);
    return x * (y + z) + y * z + x + y + z;
  }
}

/// All bits of the lanes from `first` on.
[[nodiscard]] inline LongLanes lanes_from(std::size_t first) noexcept {
  static constexpr std::array<std::int64_t, 2 * long_lane_count> marks{0, 0, 0, 0, -1, -1, -1, -1};
  LongWords words;
  std::memcpy(&words, &marks[long_lane_count - first], sizeof words);
  return LongLanes(words);
}

/// Bit 2 i for bit i, for four bits.
[[nodiscard]] constexpr std::uint32_t spread_bits(std::uint32_t bits) noexcept {
  bits = (bits | bits << 2) & 0x33;
  return (bits | bits << 1) & 0x55;
}

/// The half areas of the boxes of a node, and of the same boxes extended by `box`, four at a time:
/// first those of even boxes, then those of odd ones.
template <Scalar S, int N>
class HalfAreas {
  using Node = TreeNode<S, N>;

  using Areas = std::array<LongLanes, 2>;

 public:
  HalfAreas(const Node& node, const QuantizedBox<S, N>& box) noexcept {
    std::array<typename Node::Lane, static_cast<std::size_t>(N)> lows, highs;
    for (std::size_t axis = 0; axis < lows.size(); ++axis) {
      Lanes<std::int32_t> low(node.low[axis]), high(node.high[axis]);
      low.lower(Lanes<std::int32_t>(box.low[axis]));
      high.raise(Lanes<std::int32_t>(box.high[axis]));
      low.store(lows[axis]);
      high.store(highs[axis]);
    }
    own_ = of_all(node.low, node.high);
    extended_ = of_all(lows, highs);
  }

  /// Which of the first `count` boxes grows least; ties go to the smallest. Only ties branch, because
  /// the best box is unpredictable.
  [[nodiscard]] std::size_t best_place(std::size_t count) const noexcept {
    const LongLanes even = growth(0, count), odd = growth(1, count);
    const auto least = LongLanes::select(LongLanes::above(even, odd), odd, even).least();
    const auto above = [&](const LongLanes& lanes) {
      return spread_bits(LongLanes::above(lanes, least).signs());
    };
    auto ties = 0xff ^ (above(even) | above(odd) << 1);
    auto best = static_cast<std::size_t>(std::countr_zero(ties));
    for (ties &= ties - 1; ties != 0; ties &= ties - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(ties));
      if (own(i) < own(best)) best = i;
    }
    return best;
  }

 private:
  [[nodiscard]] LongLanes growth(std::size_t odd, std::size_t count) const noexcept {
    const LongLanes most((std::numeric_limits<std::int64_t>::max)());
    return LongLanes::select(lanes_from((count + 1 - odd) / 2), most, extended_[odd] - own_[odd]);
  }
  [[nodiscard]] std::int64_t own(std::size_t i) const noexcept {
    return own_[i % 2].words()[i / 2];
  }

  template <class Sides>
  static Areas of_all(const Sides& lows, const Sides& highs) noexcept {
    using Extents = std::array<std::uint32_t, Node::width>;
    std::array<Areas, static_cast<std::size_t>(N)> extents;
    for (std::size_t axis = 0; axis < extents.size(); ++axis) {
      Lanes<std::uint32_t> lanes(std::bit_cast<Extents>(highs[axis]));
      lanes.subtract(Lanes<std::uint32_t>(std::bit_cast<Extents>(lows[axis])));
      Extents doubled;
      lanes.store(doubled);
      const LongLanes both(std::bit_cast<LongWords>(doubled));  // even ones in lower halves
      extents[axis] = {(both << 32) >> 33, both >> 33};         // area_extent
    }
    Areas areas;
    for (std::size_t odd = 0; odd < areas.size(); ++odd) {
      const auto &x = extents[0][odd], &y = extents[1][odd];
      areas[odd] = x + y;
      if constexpr (N == 3) {
        const auto& z = extents[2][odd];
        areas[odd] = areas[odd] + z + LongLanes::product(x, y) + LongLanes::product(y, z) +
                     LongLanes::product(z, x);
      }
    }
    return areas;
  }

  Areas own_, extended_;
};

/// The box of a node that grows least in area when extended by `box`; ties go to the smallest.
template <Scalar S, int N>
[[nodiscard]] constexpr std::size_t best_place(const TreeNode<S, N>& node,
                                               const QuantizedBox<S, N>& box) noexcept {
  if constexpr (is_fixed<S> && has_long_lanes) {
    if (!__builtin_is_constant_evaluated())
      return HalfAreas<S, N>(node, box).best_place(node.count);
  }
  std::size_t best = 0;
  typename Grid<S>::Area best_growth{}, best_area{};
  for (std::size_t i = 0; i < node.count; ++i) {
    const auto area = half_area(node.box(i));
    const auto growth = half_area(hull_of(node.box(i), box)) - area;
    if (i == 0 || growth < best_growth || (growth == best_growth && area < best_area)) {
      best = i;
      best_growth = growth;
      best_area = area;
    }
  }
  return best;
}

/// Twice the center.
template <Scalar S, int N>
[[nodiscard]] constexpr auto center(const QuantizedBox<S, N>& box) noexcept {
  auto result = box.low;
  for (std::size_t axis = 0; axis < result.size(); ++axis) result[axis] += box.high[axis];
  return result;
}

/// Orders by center along an axis.
[[nodiscard]] constexpr auto by_center(std::size_t axis) noexcept {
  return [axis](const auto& a, const auto& b) { return center(a)[axis] < center(b)[axis]; };
}

/// The center of an entry, and its index in a list. Moving these is faster than moving entries.
template <Scalar S, int N>
struct CenteredPlace {
  decltype(center(QuantizedBox<S, N>())) at;
  std::uint32_t place;

  [[nodiscard]] friend constexpr const auto& center(const CenteredPlace& part) noexcept {
    return part.at;
  }
};

template <Scalar S, int N>
[[nodiscard]] constexpr auto center(const TreeEntry<S, N>& entry) noexcept {
  return center(entry.box);
}

template <Scalar S, int N>
constexpr void part_at(TreeEntry<S, N>* first, std::size_t count, std::size_t place,
                       std::size_t axis) {
  std::nth_element(first, first + place, first + count, by_center(axis));
}

/// Reorders as std::nth_element does. Its loop has no branch that depends on the centers, because
/// such branches are hard to predict.
template <Scalar S, int N>
constexpr void part_at(CenteredPlace<S, N>* first, std::size_t count, std::size_t place,
                       std::size_t axis) {
  // Moves the parts that pass to the front, and returns their number.
  const auto gather = [&](const auto& passes) {
    std::size_t passed = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const auto part = first[i];
      first[i] = first[passed];
      first[passed] = part;
      passed += passes(part.at[axis]) ? 1u : 0u;
    }
    return passed;
  };
  for (auto rounds = 4 * std::bit_width(count); count > 1; --rounds) {
    if (rounds == 0) {
      return std::nth_element(first, first + place, first + count, by_center(axis));
    }
    const auto a = first[count / 4].at[axis], b = first[count / 2].at[axis],
               c = first[count - 1 - count / 4].at[axis];
    const auto pivot = (std::max)((std::min)(a, b), (std::min)((std::max)(a, b), c));
    auto passed = gather([&](const auto& x) { return x < pivot; });
    if (place < passed) {
      count = passed;
      continue;
    }
    if (passed == 0) {  // the pivot is the least
      passed = gather([&](const auto& x) { return !(pivot < x); });
      if (place < passed) return;
    }
    first += passed;
    count -= passed;
    place -= passed;
  }
}

/// Orders entries so that neighbours are near each other: repeatedly cuts them in two along the
/// axis with the greatest spread of centers, between whole subtrees.
template <Scalar S, int N, class Part>
constexpr void arrange(Part* first, std::size_t count) {
  constexpr std::size_t width = TreeNode<S, N>::width;
  while (count > width) {
    std::size_t part = width;
    while (part * width < count) part *= width;
    const auto parts = (count + part - 1) / part;
    const auto cut = (parts + 1) / 2 * part;
    auto lowest = center(first[0]), highest = lowest;
    for (std::size_t i = 1; i < count; ++i) {
      const auto c = center(first[i]);
      for (std::size_t axis = 0; axis < c.size(); ++axis) {
        lowest[axis] = (std::min)(lowest[axis], c[axis]);
        highest[axis] = (std::max)(highest[axis], c[axis]);
      }
    }
    std::size_t axis = 0;
    for (std::size_t i = 1; i < lowest.size(); ++i) {
      if (Grid<S>::area_extent(lowest[i], highest[i]) >
          Grid<S>::area_extent(lowest[axis], highest[axis])) {
        axis = i;
      }
    }
    part_at(first, count, cut, axis);
    arrange<S, N>(first + cut, count - cut);
    count = cut;
  }
}

/// The indices of entries, sorted by their centers on an axis; equal centers keep their order.
template <Scalar S, int N, std::size_t Count>
[[nodiscard]] constexpr std::array<std::uint8_t, Count> order_along(
    std::size_t axis, const std::array<TreeEntry<S, N>, Count>& entries) noexcept {
  static_assert(Count <= 16);
  std::array<std::uint8_t, Count> order{};
  if constexpr (is_fixed<S> && has_lanes) {
    // Branchless: on large processors, unpredictable branches cost most.
    std::array<std::int64_t, Count> keys{};
    for (std::size_t i = 0; i < Count; ++i) {
      keys[i] = std::int64_t{center(entries[i])[axis]} * 16 + static_cast<std::int64_t>(i);
    }
    for (std::size_t round = 0; round < Count; ++round) {
      for (std::size_t i = round % 2; i + 1 < Count; i += 2) {
        const auto a = keys[i], b = keys[i + 1];
        keys[i] = b < a ? b : a;
        keys[i + 1] = b < a ? a : b;
      }
    }
    for (std::size_t i = 0; i < Count; ++i) order[i] = static_cast<std::uint8_t>(keys[i] & 15);
  } else {
    for (std::size_t i = 0; i < Count; ++i) {
      const auto at = center(entries[i])[axis];
      auto place = i;
      for (; place > 0 && at < center(entries[order[place - 1]])[axis]; --place) {
        order[place] = order[place - 1];
      }
      order[place] = static_cast<std::uint8_t>(i);
    }
  }
  return order;
}

/// Orders entries along an axis and returns where to cut, with at least `least` entries on either
/// side, so that the boxes around both sides have the least area.
template <Scalar S, int N, std::size_t Count>
[[nodiscard]] constexpr std::size_t cut_in_two(std::array<TreeEntry<S, N>, Count>& entries,
                                               std::size_t least) noexcept {
  std::array<std::uint8_t, Count> best{};
  std::size_t best_cut = 0;
  typename Grid<S>::Area best_cost{};
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(N); ++axis) {
    const auto order = order_along(axis, entries);
    std::array<QuantizedBox<S, N>, Count> rest;  // rest[i] is around the entries from i on
    rest[Count - 1] = entries[order[Count - 1]].box;
    for (std::size_t i = Count - 1; i-- > least;) {
      rest[i] = hull_of(entries[order[i]].box, rest[i + 1]);
    }
    auto first = entries[order[0]].box;
    for (std::size_t cut = 1; cut <= Count - least; ++cut) {
      if (cut >= least) {
        const auto cost = half_area(first) + half_area(rest[cut]);
        if (best_cut == 0 || cost < best_cost) {
          best = order;
          best_cut = cut;
          best_cost = cost;
        }
      }
      first = hull_of(first, entries[order[cut]].box);
    }
  }
  const auto unordered = entries;
  for (std::size_t i = 0; i < Count; ++i) entries[i] = unordered[best[i]];
  return best_cut;
}

}  // namespace detent::detail
