// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <span>

#include "detent/query/intersects/aabb.hpp"
#include "detent/scene/static_tree/within.hpp"

namespace detent {

namespace detail {

/// Whether `segment` may touch what is in `box`: exactly as `intersects` in fixed point, with a
/// margin for rounding in floating point.
template <Scalar S, int N>
[[nodiscard]] constexpr bool may_cross(const Segment<S, N>& segment,
                                       const Aabb<S, N>& box) noexcept {
  if constexpr (is_fixed<S>) {
    return intersects(segment, box);
  } else {
    S reach{};
    for (int i = 0; i < N; ++i) {
      reach = (std::max)(
          {reach, abs(segment.start[i]), abs(segment.end[i]), abs(box.min[i]), abs(box.max[i])});
    }
    const S margin = reach / (1 << 18);
    const auto grown = make_vec<N>([&](int) { return margin; });
    return intersects(segment, Aabb<S, N>{box.min - grown, box.max + grown});
  }
}

}  // namespace detail

/// Visits the items whose boxes `segment` may touch: calls visit(part) for parts of the tree's list
/// of items, until it returns true. Returns whether it did.
///
/// Every item whose box it touches is visited; others may be.
template <Scalar S, int N, class Item, class Visit>
constexpr bool visit_crossing(const StaticTree<S, N>& tree, std::span<const Item> items,
                              const Segment<S, N>& segment, const Visit& visit) noexcept {
  if (tree.nodes.empty()) return false;
  const auto around = bounding_box(segment);
  detail::StaticStack<bool> stack;
  stack.insert(0, {false, 0, 0});
  while (!stack.empty()) {
    const auto [key, first, count] = stack.pop();
    if (count != 0) {
      if (visit(items.subspan(first, count))) return true;
      continue;
    }
    const auto& node = tree.nodes[first];
    for (auto met = detail::touching(node, around); met != 0; met &= met - 1) {
      const auto child = static_cast<std::size_t>(std::countr_zero(met));
      if (!detail::may_cross(segment, node.box(child))) continue;
      stack.insert(stack.size(), {false, node.first[child], node.count[child]});
    }
  }
  return false;
}

}  // namespace detent
