// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

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

/// The box of a node that grows least in area when extended by `box`; ties go to the smallest.
template <Scalar S, int N>
[[nodiscard]] constexpr std::size_t best_place(const TreeNode<S, N>& node,
                                               const QuantizedBox<S, N>& box) noexcept {
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
  return [axis](const auto& a, const auto& b) { return center(a.box)[axis] < center(b.box)[axis]; };
}

/// Orders entries so that neighbours are near each other: repeatedly cuts them in two along the
/// axis with the greatest spread of centers, between whole subtrees.
template <Scalar S, int N>
constexpr void arrange(TreeEntry<S, N>* first, std::size_t count) {
  constexpr std::size_t width = TreeNode<S, N>::width;
  while (count > width) {
    std::size_t part = width;
    while (part * width < count) part *= width;
    const auto parts = (count + part - 1) / part;
    const auto cut = (parts + 1) / 2 * part;
    auto lowest = center(first[0].box), highest = lowest;
    for (std::size_t i = 1; i < count; ++i) {
      const auto c = center(first[i].box);
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
    std::nth_element(first, first + cut, first + count, by_center(axis));
    arrange(first + cut, count - cut);
    count = cut;
  }
}

/// Orders entries along an axis and returns where to cut, with at least `least` entries on either
/// side, so that the boxes around both sides have the least area.
template <Scalar S, int N, std::size_t Count>
[[nodiscard]] constexpr std::size_t cut_in_two(std::array<TreeEntry<S, N>, Count>& entries,
                                               std::size_t least) noexcept {
  auto best = entries;
  std::size_t best_cut = 0;
  typename Grid<S>::Area best_cost{};
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(N); ++axis) {
    std::sort(entries.begin(), entries.end(), by_center(axis));
    std::array<QuantizedBox<S, N>, Count> rest;  // rest[i] is around the entries from i on
    rest[Count - 1] = entries[Count - 1].box;
    for (std::size_t i = Count - 1; i-- > 0;) rest[i] = hull_of(entries[i].box, rest[i + 1]);
    auto first = entries[0].box;
    for (std::size_t cut = 1; cut <= Count - least; ++cut) {
      if (cut >= least) {
        const auto cost = half_area(first) + half_area(rest[cut]);
        if (best_cut == 0 || cost < best_cost) {
          best = entries;
          best_cut = cut;
          best_cost = cost;
        }
      }
      first = hull_of(first, entries[cut].box);
    }
  }
  entries = best;
  return best_cut;
}

}  // namespace detent::detail
