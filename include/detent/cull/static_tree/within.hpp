// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "detent/cull/static_tree/parts.hpp"
#include "detent/cull/walk.hpp"

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

/// A static tree as traversed by a search in a box.
template <Scalar S, int N, class MayTouch>
struct TreeWithin : StaticParts<Unordered, S, N> {
  using Node = StaticNode<S, N>;

  const Aabb<S, N>& around;
  const MayTouch& may_touch;

  [[nodiscard]] constexpr std::uint32_t meets(
      const Node& node, std::array<Unordered, Node::width>& /*keys*/) const noexcept {
    std::uint32_t met = 0;
    for (auto left = touching(node, around); left != 0; left &= left - 1) {
      if (may_touch(node, static_cast<std::size_t>(std::countr_zero(left)))) {
        met |= left & (~left + 1);
      }
    }
    return met;
  }
  [[nodiscard]] constexpr bool reaches(const Unordered&) const noexcept { return true; }
};

template <Scalar S, int N, class Item, class MayTouch, class Visit>
constexpr Walk visit_touching(const StaticTree<S, N>& tree, std::span<const Item> items,
                              const Aabb<S, N>& around, const MayTouch& may_touch,
                              const Visit& visit) noexcept {
  if (tree.nodes.empty() || is_empty(around)) return Walk::go_on;
  const TreeWithin<S, N, MayTouch> within{{tree}, around, may_touch};
  return visit_nearest_first(whole_tree, within, [&](const StaticPart& leaf) {
    return visit(items.subspan(leaf.first, leaf.count));
  });
}

}  // namespace detail

/// Visits the items whose boxes may touch something in the box `around`: calls visit(part) for parts
/// of the tree's list of items. may_touch(box) returns whether the contents of a box that meets
/// `around` may matter.
template <Scalar S, int N, class Item, class MayTouch, class Visit>
constexpr Walk visit_crossing(const StaticTree<S, N>& tree, std::span<const Item> items,
                              const Aabb<S, N>& around, const MayTouch& may_touch,
                              const Visit& visit) noexcept {
  return detail::visit_touching(
      tree, items, around,
      [&](const StaticNode<S, N>& node, std::size_t k) { return may_touch(node.box(k)); }, visit);
}

/// Visits the items whose boxes may touch `box`.
template <Scalar S, int N, class Item, class Visit>
constexpr Walk visit_within(const StaticTree<S, N>& tree, std::span<const Item> items,
                            const Aabb<S, N>& box, const Visit& visit) noexcept {
  return detail::visit_touching(
      tree, items, box, [](const auto&, std::size_t) { return true; }, visit);
}

}  // namespace detent
