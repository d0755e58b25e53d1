// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "detent/cull/static_tree/parts.hpp"
#include "detent/cull/walk.hpp"

namespace detent {

namespace detail {

/// A static tree as traversed by a nearest-item search.
template <Scalar S, int N, class DistanceTo>
struct TreeAround : StaticParts<S, S, N> {
  using Node = StaticNode<S, N>;

  const DistanceTo& distance_to;
  S limit;

  [[nodiscard]] constexpr std::uint32_t meets(const Node& node,
                                              std::array<S, Node::width>& keys) const noexcept {
    std::uint32_t met = 0;
    for (std::size_t k = 0; k < node.children; ++k) {
      // Rounding down and clamping preserve order, so a box is never farther than its contents.
      keys[k] = distance_to(node.box(k));
      if (keys[k] <= limit) met |= std::uint32_t{1} << k;
    }
    return met;
  }
  [[nodiscard]] constexpr bool reaches(const S& to_box) const noexcept { return to_box <= limit; }
};

}  // namespace detail

/// Visits the items whose boxes may be near enough to matter, the nearest first: calls
/// visit(part, limit) for parts of the tree's list of items. distance_to(box) is the distance of a
/// box, rounded down; `limit` is such a distance.
template <Scalar S, int N, class Item, class DistanceTo, class Visit>
constexpr Walk visit_around(const StaticTree<S, N>& tree, std::span<const Item> items,
                            const DistanceTo& distance_to, const Visit& visit) noexcept {
  if (tree.nodes.empty()) return Walk::go_on;
  detail::TreeAround<S, N, DistanceTo> around{{tree}, distance_to, largest<S>};
  return detail::visit_nearest_first(
      detail::whole_tree, around, [&](const detail::StaticPart& leaf) {
        return visit(items.subspan(leaf.first, leaf.count), around.limit);
      });
}

}  // namespace detent
