// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include "detent/cull/static_tree/stack.hpp"

namespace detent {

namespace detail {

/// Which children's boxes may touch `box`, a bit for each. Compares bytes on the node's grid.
template <Scalar S, int N>
[[nodiscard]] constexpr std::uint32_t touching(const StaticNode<S, N>& node,
                                               const Aabb<S, N>& box) noexcept {
  std::uint32_t met = (std::uint32_t{1} << node.children) - 1;
  for (std::size_t i = 0; i < N; ++i) {
    const auto low = node.grids[i].below(box.min[static_cast<int>(i)]);
    const auto high = node.grids[i].above(box.max[static_cast<int>(i)]);
    for (std::size_t k = 0; k < node.width; ++k) {
      const bool apart = node.sides[2 * i][k] > high || node.sides[2 * i + 1][k] < low;
      met &= ~(apart ? std::uint32_t{1} << k : 0);
    }
  }
  return met;
}

}  // namespace detail

/// Visits the items whose boxes may touch `box`: calls visit(part) for parts of the tree's list of
/// items, until it returns true. Returns whether it did.
///
/// Every item whose box touches it is visited; others may be.
template <Scalar S, int N, class Item, class Visit>
constexpr bool visit_within(const StaticTree<S, N>& tree, std::span<const Item> items,
                            const Aabb<S, N>& box, const Visit& visit) noexcept {
  if (tree.nodes.empty() || is_empty(box)) return false;
  detail::StaticStack<bool> stack;
  stack.insert(0, {false, 0, 0});
  while (!stack.empty()) {
    const auto [key, first, count] = stack.pop();
    if (count != 0) {
      if (visit(items.subspan(first, count))) return true;
      continue;
    }
    const auto& node = tree.nodes[first];
    for (auto met = detail::touching(node, box); met != 0; met &= met - 1) {
      const auto child = static_cast<std::size_t>(std::countr_zero(met));
      stack.insert(stack.size(), {false, node.first[child], node.count[child]});
    }
  }
  return false;
}

}  // namespace detent
