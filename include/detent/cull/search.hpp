// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "detent/cull/prefetch.hpp"
#include "detent/cull/tree.hpp"
#include "detent/shape/ray.hpp"

// Traversals of a tree of boxes. They only cull; exact queries on the objects decide.

namespace detent::detail {

/// Which boxes a ray may reach, and lower bounds on the times when it does.
template <Scalar S, int N>
class RayProbe {
 public:
  using Key = typename Grid<S>::Time;

  explicit constexpr RayProbe(const Ray<S, N>& ray) noexcept {
    for (int i = 0; i < N; ++i) {
      axes_[static_cast<std::size_t>(i)] = CullingAxis<S>(ray.origin[i], ray.direction[i]);
    }
    shorten(ray.max_distance);
  }

  /// From now on, only boxes that may lie within `distance`.
  constexpr void shorten(const S& distance) noexcept {
    limit_ = Key{Grid<S>::above(distance)} + CullingAxis<S>::slack;
  }
  [[nodiscard]] constexpr bool reaches(Key key) const noexcept { return key <= limit_; }

  constexpr auto keys(const TreeNode<S, N>& node,
                      std::array<Key, TreeNode<S, N>::width>& keys) const noexcept {
    constexpr auto width = TreeNode<S, N>::width;
    std::array<Key, width> exits;
    keys.fill(Key(0));
    exits.fill(limit_);
    for (std::size_t axis = 0; axis < axes_.size(); ++axis) {
      const auto& line = axes_[axis];
      const auto& front = line.is_negative() ? node.high[axis] : node.low[axis];
      const auto& back = line.is_negative() ? node.low[axis] : node.high[axis];
      for (std::size_t i = 0; i < width; ++i) {
        keys[i] = (std::max)(keys[i], line.enter(front[i]));
        exits[i] = (std::min)(exits[i], line.exit(back[i]));
      }
    }
    typename TreeNode<S, N>::Mask mask = 0;
    for (std::size_t i = 0; i < width; ++i) {
      mask |= keys[i] <= exits[i] + CullingAxis<S>::slack ? 1u << i : 0u;
    }
    return mask & ((1u << node.count) - 1);
  }

 private:
  std::array<CullingAxis<S>, static_cast<std::size_t>(N)> axes_;
  Key limit_{};
};

/// Which boxes may lie within a distance of a point, and the squares of their distances.
template <Scalar S, int N>
class PointProbe {
 public:
  using Key = typename Grid<S>::Area;

  explicit constexpr PointProbe(const Vec<S, N>& point) noexcept : box_(quantized_box(point)) {}

  constexpr void shorten(const S& distance) noexcept {
    if (distance >= largest<S>) return;  // greater distances are clamped to it
    is_limited_ = true;
    const auto limit = static_cast<Key>(Grid<S>::above(distance)) + Key(1);  // rounded down
    limit_ = limit * limit;
  }
  /// A distance measured in the frame of a box may be 2^-8 less (bounds.hpp).
  [[nodiscard]] constexpr bool reaches(Key key) const noexcept {
    return !is_limited_ || key - key / 64 <= limit_;
  }

  constexpr auto keys(const TreeNode<S, N>& node,
                      std::array<Key, TreeNode<S, N>::width>& keys) const noexcept {
    typename TreeNode<S, N>::Mask mask = 0;
    for (std::size_t i = 0; i < node.count; ++i) {
      keys[i] = Key(0);
      for (std::size_t axis = 0; axis < box_.low.size(); ++axis) {
        // Below 2^31, so that three squares fit 64 bits.
        Key gap(0);
        if (node.low[axis][i] > box_.high[axis]) gap = extent(box_.high[axis], node.low[axis][i]);
        if (node.high[axis][i] < box_.low[axis]) gap = extent(node.high[axis][i], box_.low[axis]);
        keys[i] += gap * gap;
      }
      mask |= reaches(keys[i]) ? 1u << i : 0u;
    }
    return mask;
  }

 private:
  using Coordinate = typename Grid<S>::Coordinate;
  static constexpr Key extent(Coordinate low, Coordinate high) noexcept {
    return static_cast<Key>(high) - static_cast<Key>(low);
  }

  QuantizedBox<S, N> box_;
  Key limit_{};
  bool is_limited_ = false;
};

/// Calls visit(object) for the objects whose boxes `probe` reaches, nearer boxes first, until it
/// returns true. `visit` may shorten the probe.
template <class Tree, class Probe, class Visit>
constexpr bool visit_nearest(const Tree& tree, Probe& probe, const Visit& visit) {
  struct Step {
    typename Probe::Key key;
    std::uint32_t at;
  };
  if (tree.is_empty()) return false;
  std::array<Step, Tree::depth*(Tree::width - 1) + 1> stack;
  std::size_t size = 0;
  stack[size++] = {{}, tree.root()};
  std::array<typename Probe::Key, Tree::width> keys;
  while (size > 0) {
    const auto [key, at] = stack[--size];
    if (!probe.reaches(key)) continue;
    const auto& node = tree.node(at);
    // The farthest first: they are pushed on the stack, or visited from the back, in a leaf.
    std::array<Step, Tree::width> sorted;
    std::size_t count = 0;
    for (auto mask = probe.keys(node, keys); mask != 0; mask &= mask - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(mask));
      auto place = count++;
      for (; place > 0 && sorted[place - 1].key < keys[i]; --place)
        sorted[place] = sorted[place - 1];
      sorted[place] = {keys[i], node.child[i]};
    }
    if (node.level > 0) {
      for (std::size_t i = 0; i < count; ++i) {
        prefetch(&tree.node(sorted[i].at), sizeof(node));
        stack[size++] = sorted[i];
      }
    } else {
      while (count-- > 0) {
        if (probe.reaches(sorted[count].key) && visit(sorted[count].at)) return true;
      }
    }
  }
  return false;
}

/// Calls visit(object) for the objects whose boxes overlap `box`, until it returns true.
template <class Tree, class Visit>
constexpr bool visit_meeting(const Tree& tree, const typename Tree::Box& box, const Visit& visit) {
  if (tree.is_empty() || box.is_empty()) return false;
  std::array<std::uint32_t, Tree::depth*(Tree::width - 1) + 1> stack;
  std::size_t size = 0;
  stack[size++] = tree.root();
  while (size > 0) {
    const auto& node = tree.node(stack[--size]);
    for (auto mask = node.meeting(box); mask != 0; mask &= mask - 1) {
      const auto child = node.child[static_cast<std::size_t>(std::countr_zero(mask))];
      if (node.level > 0) {
        stack[size++] = child;
      } else if (visit(child)) {
        return true;
      }
    }
  }
  return false;
}

/// Calls visit(a, b) for the pairs of objects with overlapping boxes, one below node `a` of one
/// tree and one below node `b` of another.
template <class Tree, class Visit>
constexpr void visit_pairs_below(const Tree& first, std::uint32_t a, const Tree& second,
                                 std::uint32_t b, const Visit& visit) {
  const auto& node_a = first.node(a);
  const auto& node_b = second.node(b);
  if (node_a.level < node_b.level) {
    const auto bounds = node_a.bounds();
    for (auto mask = node_b.meeting(bounds); mask != 0; mask &= mask - 1) {
      const auto j = static_cast<std::size_t>(std::countr_zero(mask));
      visit_pairs_below(first, a, second, node_b.child[j], visit);
    }
    return;
  }
  if (node_a.level > node_b.level) {
    const auto bounds = node_b.bounds();
    for (auto mask = node_a.meeting(bounds); mask != 0; mask &= mask - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(mask));
      visit_pairs_below(first, node_a.child[i], second, b, visit);
    }
    return;
  }
  for (auto rows = node_a.meeting(node_b.bounds()); rows != 0; rows &= rows - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(rows));
    for (auto mask = node_b.meeting(node_a.box(i)); mask != 0; mask &= mask - 1) {
      const auto j = static_cast<std::size_t>(std::countr_zero(mask));
      if (node_a.level == 0) {
        visit(node_a.child[i], node_b.child[j]);
      } else {
        visit_pairs_below(first, node_a.child[i], second, node_b.child[j], visit);
      }
    }
  }
}

/// Calls visit(a, b) once for each pair of objects below node `at` whose boxes overlap.
template <class Tree, class Visit>
constexpr void visit_pairs(const Tree& tree, std::uint32_t at, const Visit& visit) {
  const auto& node = tree.node(at);
  if (node.level > 0) {
    for (std::size_t i = 0; i < node.count; ++i) prefetch(&tree.node(node.child[i]), sizeof(node));
  }
  for (std::size_t i = 0; i < node.count; ++i) {
    if (node.level > 0) visit_pairs(tree, node.child[i], visit);
    const auto later = node.meeting(node.box(i)) & ~((2u << i) - 1);
    for (auto mask = later; mask != 0; mask &= mask - 1) {
      const auto j = static_cast<std::size_t>(std::countr_zero(mask));
      if (node.level == 0) {
        visit(node.child[i], node.child[j]);
      } else {
        visit_pairs_below(tree, node.child[i], tree, node.child[j], visit);
      }
    }
  }
}

}  // namespace detent::detail
