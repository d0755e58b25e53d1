// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "detent/cull/static_tree/stack.hpp"

namespace detent {

/// Visits the items whose boxes may be near enough to matter, the nearest first: calls visit(part)
/// for parts of the tree's list of items. distance_to(box) is the distance of a box, rounded down;
/// visit returns the distance beyond which nothing matters any more, never more than before.
///
/// Every item whose box is no farther than that is visited; others may be.
template <Scalar S, int N, class Item, class DistanceTo, class Visit>
constexpr void visit_around(const StaticTree<S, N>& tree, std::span<const Item> items,
                            const DistanceTo& distance_to, const Visit& visit) noexcept {
  if (tree.nodes.empty()) return;
  detail::StaticStack<S> stack;
  S limit = largest<S>;
  stack.insert(0, {S(0), 0, 0});
  while (!stack.empty()) {
    const auto [key, first, count] = stack.pop();
    if (key > limit) continue;
    if (count != 0) {
      limit = visit(items.subspan(first, count));
      continue;
    }
    const auto& node = tree.nodes[first];
    const std::size_t base = stack.size();
    for (std::size_t k = 0; k < node.children; ++k) {
      // Rounding down and clamping keep order, so a box is never farther than its contents.
      const S to_box = distance_to(node.box(k));
      if (to_box <= limit) stack.insert(base, {to_box, node.first[k], node.count[k]});
    }
  }
}

}  // namespace detent
