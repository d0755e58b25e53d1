// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "detent/cull/static_tree/node.hpp"

namespace detent {

namespace detail {

/// A part of a static tree: the node with index `first`, or `count` items from `first` on.
struct StaticPart {
  std::uint32_t first = 0;
  std::uint32_t count = 0;

  /// The most parts that wait in a traversal: seven of each level above and the eight of the last.
  static constexpr std::size_t room = 7 * (static_tree_depth - 1) + 8;

  [[nodiscard]] constexpr bool is_leaf() const noexcept { return count != 0; }
};

}  // namespace detail

/// Whether test(child, box) is true for any child of a node of the tree; stops at the first. `box`
/// is the box of the child, clipped to the bounds of the tree.
template <Scalar S, int N, class Test>
constexpr bool any_child(const StaticTree<S, N>& tree, const detail::StaticPart& part,
                         const Test& test) noexcept {
  const auto& node = tree.nodes[part.first];
  for (std::size_t k = 0; k < node.children; ++k) {
    auto box = node.box(k);
    for (int i = 0; i < N; ++i) {
      box.min[i] = (std::max)(box.min[i], tree.bounds.min[i]);
      box.max[i] = (std::min)(box.max[i], tree.bounds.max[i]);
    }
    if (test(detail::StaticPart{node.first[k], node.count[k]}, box)) return true;
  }
  return false;
}

}  // namespace detent
