// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstddef>
#include <span>

#include "detent/cull/static_tree/within.hpp"

namespace detent {

/// Visits the items whose boxes may touch something in the box `around`: calls visit(part) for parts
/// of the tree's list of items, until it returns true. Returns whether it did. may_touch(box) says
/// whether the contents of a box that meets `around` may matter.
///
/// Every item whose box may matter is visited; others may be.
template <Scalar S, int N, class Item, class MayTouch, class Visit>
constexpr bool visit_crossing(const StaticTree<S, N>& tree, std::span<const Item> items,
                              const Aabb<S, N>& around, const MayTouch& may_touch,
                              const Visit& visit) noexcept {
  if (tree.nodes.empty()) return false;
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
      if (!may_touch(node.box(child))) continue;
      stack.insert(stack.size(), {false, node.first[child], node.count[child]});
    }
  }
  return false;
}

}  // namespace detent
