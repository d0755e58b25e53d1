// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "detent/cull/static_tree/node.hpp"
#include "detent/cull/walk.hpp"

namespace detent {

namespace detail {

/// A part of a static tree: the node with index `first`, or `count` items from `first` on.
struct StaticPart {
  std::uint32_t first;
  std::uint32_t count;

  static constexpr std::size_t most_children = 8;
  /// The most parts pending in a walk: seven per level.
  static constexpr std::size_t room = (most_children - 1) * static_tree_depth;

  [[nodiscard]] constexpr bool is_leaf() const noexcept { return count != 0; }
};

inline constexpr StaticPart whole_tree{0, 0};

/// A static tree for walks; `KeyOf` measures how near a part is.
template <class KeyOf, Scalar S, int N>
struct StaticParts {
  using Key = KeyOf;
  using Part = StaticPart;
  static constexpr std::size_t most_children = Part::most_children, room = Part::room;

  const StaticTree<S, N>& tree;

  [[nodiscard]] constexpr const StaticNode<S, N>& node(const Part& part) const noexcept {
    return tree.nodes[part.first];
  }
  [[nodiscard]] constexpr Part child(const StaticNode<S, N>& node, std::size_t k) const noexcept {
    return {node.first[k], node.count[k]};
  }
};

}  // namespace detail

/// Visits the children of a node: calls visit(child, box), where `box` is the box of the child,
/// clipped to the bounds of the tree.
template <Scalar S, int N, class Visit>
constexpr Walk visit_children(const StaticTree<S, N>& tree, const detail::StaticPart& part,
                              const Visit& visit) noexcept {
  const auto& node = tree.nodes[part.first];
  for (std::size_t k = 0; k < node.children; ++k) {
    auto box = node.box(k);
    for (int i = 0; i < N; ++i) {
      box.min[i] = (std::max)(box.min[i], tree.bounds.min[i]);
      box.max[i] = (std::min)(box.max[i], tree.bounds.max[i]);
    }
    const Walk walk = visit(detail::StaticPart{node.first[k], node.count[k]}, box);
    if (walk == Walk::stop) return Walk::stop;
  }
  return Walk::go_on;
}

}  // namespace detent
