// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "detent/cull/byte_grid.hpp"
#include "detent/shape/bounding_box.hpp"

namespace detent {

/// A node of a tree of boxes: up to eight children, with a box around each.
///
/// Boxes are rounded outward to one byte per side, on a grid over the node's own box, so a node
/// with 32-bit coordinates takes two cache lines. The same side of all boxes is contiguous, so one
/// vector instruction tests all children. A child is another node, or a few items of the tree's
/// list.
template <Scalar S, int N>
struct alignas(64) StaticNode {
  static constexpr std::size_t width = 8;

  std::array<ByteGrid<S>, std::size_t{N}> grids;
  /// sides[2 * axis] is the least coordinate of each child's box on an axis, sides[2 * axis + 1]
  /// the greatest.
  std::array<std::array<std::uint8_t, width>, 2 * std::size_t{N}> sides{};
  /// The child's index in the list of nodes, or the index of its first item.
  std::array<std::uint32_t, width> first{};
  /// The number of its items; 0 for a node.
  std::array<std::uint8_t, width> count{};
  /// The number of children, which come first in the arrays.
  std::uint8_t children = 0;

  constexpr StaticNode() noexcept = default;
  /// A node without children whose box is `bounds`.
  explicit constexpr StaticNode(const Aabb<S, N>& bounds) noexcept {
    for (int i = 0; i < N; ++i) {
      grids[static_cast<std::size_t>(i)] = ByteGrid<S>(bounds.min[i], bounds.max[i]);
    }
  }

  constexpr void add_child(const Aabb<S, N>& box, std::uint32_t at, std::uint32_t items) noexcept {
    for (std::size_t i = 0; i < N; ++i) {
      sides[2 * i][children] = grids[i].below(box.min[static_cast<int>(i)]);
      sides[2 * i + 1][children] = grids[i].above(box.max[static_cast<int>(i)]);
    }
    first[children] = at;
    count[children++] = static_cast<std::uint8_t>(items);
  }
  [[nodiscard]] constexpr Aabb<S, N> box(std::size_t child) const noexcept {
    const auto side = [&](int i, std::size_t end) {
      const auto axis = static_cast<std::size_t>(i);
      return grids[axis].plane(sides[2 * axis + end][child]);
    };
    return {make_vec<N>([&](int i) { return side(i, 0); }),
            make_vec<N>([&](int i) { return side(i, 1); })};
  }

  [[nodiscard]] friend constexpr bool operator==(const StaticNode&,
                                                 const StaticNode&) noexcept = default;
};

/// Appends to a digest: the fields in order.
template <class D, Scalar S, int N>
constexpr void append(D& digest, const StaticNode<S, N>& node) noexcept {
  for (const auto& grid : node.grids) digest.add(grid);
  for (const auto& side : node.sides) {
    for (const auto plane : side) digest.add(plane);
  }
  for (const auto first : node.first) digest.add(first);
  for (const auto count : node.count) digest.add(count);
  digest.add(node.children);
}

/// The most nodes on a path down from the root of a static tree.
inline constexpr int static_tree_depth = 20;

/// A static tree of boxes over a list of items: a view of nodes that the caller owns, the root
/// first. A tree over no items has no nodes.
template <Scalar S, int N>
struct StaticTree {
  /// The most items in a child that is a leaf.
  static constexpr std::uint32_t leaf_size = 4;

  std::span<const StaticNode<S, N>> nodes;
  Aabb<S, N> bounds = detail::no_box<Aabb<S, N>>;
};

/// The most nodes that a tree over `count` items can have.
///
/// Of I nodes, let L have no node as a child; each of these holds 5 items or more (the root may
/// hold fewer). The others have eight children each. So 8 (I - L) <= (I - 1) + (count - 5 L)
/// children, that is I <= (count + 3 L) / 7 <= (1 + 3/5) count / 7 < count / 4.
[[nodiscard]] constexpr std::size_t tree_capacity(std::size_t count) noexcept {
  return count / 4 + 1;
}

}  // namespace detent
