// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "detent/cull/prefetch.hpp"
#include "detent/cull/slabs.hpp"
#include "detent/cull/tree.hpp"
#include "detent/cull/walk.hpp"
#include "detent/shape/ray.hpp"

// Traversals of a tree of boxes. They only cull; exact queries on the objects decide.

namespace detent::detail {

/// A node of a tree, or an object.
struct TreePart {
  std::uint32_t at;
  bool is_object;

  /// The most parts that wait in a walk: seven of each level.
  static constexpr std::size_t room = 7 * tree_depth;

  [[nodiscard]] constexpr bool is_leaf() const noexcept { return is_object; }
};

/// Which boxes a ray or a moving box may reach, and lower bounds on the times when it does.
template <Scalar S, int N>
class RayProbe {
 public:
  using Key = typename RaySlab<S>::Time;

  explicit constexpr RayProbe(const Ray<S, N>& ray) noexcept {
    for (int i = 0; i < N; ++i) {
      slabs_[static_cast<std::size_t>(i)] =
          RaySlab<S>(Grid<S>::step(ray.origin[i]), ray.direction[i], Ticks<S>());
    }
    shorten(ray.max_distance);
  }
  /// For what is in `box`, which is not empty, and moves: as a ray, it ends within 2^29 steps.
  constexpr RayProbe(const QuantizedBox<S, N>& box, const Direction<S, N>& direction,
                     const S& max_distance) noexcept {
    for (int i = 0; i < N; ++i) {
      const auto axis = static_cast<std::size_t>(i);
      slabs_[axis] = RaySlab<S>(box.low[axis], box.high[axis], direction[i], Ticks<S>());
    }
    shorten(max_distance);
  }

  /// From now on, only boxes that may lie within `distance`.
  constexpr void shorten(const S& distance) noexcept { limit_ = Key{Grid<S>::above(distance)}; }
  [[nodiscard]] constexpr bool reaches(Key key) const noexcept { return key <= limit_; }

  constexpr auto keys(const TreeNode<S, N>& node,
                      std::array<Key, TreeNode<S, N>::width>& keys) const noexcept {
    constexpr auto width = TreeNode<S, N>::width;
    std::array<Key, width> exits;
    keys.fill(Key(0));
    exits.fill(limit_);
    for (std::size_t axis = 0; axis < slabs_.size(); ++axis) {
      const auto& slab = slabs_[axis];
      const auto* const front = (slab.is_backward() ? node.high : node.low)[axis].data();
      const auto* const back = (slab.is_backward() ? node.low : node.high)[axis].data();
      auto *const enter = keys.data(), *const leave = exits.data();
      for (std::size_t i = 0; i < width; ++i) {
        enter[i] = (std::max)(enter[i], slab.enter(front[i]));
        leave[i] = (std::min)(leave[i], slab.leave(back[i]));
      }
    }
    typename TreeNode<S, N>::Mask mask = 0;
    for (std::size_t i = 0; i < width; ++i) {
      mask |= keys[i] <= exits[i] ? 1u << i : 0u;
    }
    return mask & ((1u << node.count) - 1);
  }

 private:
  std::array<RaySlab<S>, static_cast<std::size_t>(N)> slabs_;
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

/// A tree as a probe walks it.
template <class Tree, class Probe>
struct TreeSearch {
  using Key = typename Probe::Key;
  using Part = TreePart;
  using Node = typename Tree::Node;
  static constexpr std::size_t most_children = Tree::width, room = Part::room;

  const Tree& tree;
  const Probe& probe;

  [[nodiscard]] constexpr const Node& node(const Part& part) const noexcept {
    return tree.node(part.at);
  }
  [[nodiscard]] constexpr std::uint32_t meets(const Node& node,
                                              std::array<Key, most_children>& keys) const noexcept {
    return probe.keys(node, keys);
  }
  [[nodiscard]] constexpr Part child(const Node& node, std::size_t k) const noexcept {
    if (node.level > 0) prefetch(&tree.node(node.child[k]), sizeof(node));
    return {node.child[k], node.level == 0};
  }
  [[nodiscard]] constexpr bool reaches(const Key& key) const noexcept { return probe.reaches(key); }
};

/// Visits the objects whose boxes `probe` reaches, nearer boxes first: calls visit(object), which may
/// shorten the probe.
template <class Tree, class Probe, class Visit>
constexpr Walk visit_nearest(const Tree& tree, const Probe& probe, const Visit& visit) {
  if (tree.is_empty()) return Walk::go_on;
  const TreeSearch<Tree, Probe> search{tree, probe};
  return visit_nearest_first({tree.root(), false}, search,
                             [&](const TreePart& object) { return visit(object.at); });
}

/// Visits the objects whose boxes overlap `box`: calls visit(object).
template <class Tree, class Visit>
constexpr Walk visit_meeting(const Tree& tree, const typename Tree::Box& box, const Visit& visit) {
  if (tree.is_empty() || box.is_empty()) return Walk::go_on;
  std::array<std::uint32_t, TreePart::room + 1> stack;
  std::size_t size = 0;
  stack[size++] = tree.root();
  while (size > 0) {
    const auto& node = tree.node(stack[--size]);
    for (auto mask = node.meeting(box); mask != 0; mask &= mask - 1) {
      const auto child = node.child[static_cast<std::size_t>(std::countr_zero(mask))];
      if (node.level > 0) {
        stack[size++] = child;
      } else if (visit(child) == Walk::stop) {
        return Walk::stop;
      }
    }
  }
  return Walk::go_on;
}

/// Calls add(a, b) for the pairs of objects with overlapping boxes, one below node `a` of one
/// tree and one below node `b` of another.
template <class Tree, class Add>
constexpr void visit_pairs_below(const Tree& first, std::uint32_t a, const Tree& second,
                                 std::uint32_t b, const Add& add) {
  const auto& node_a = first.node(a);
  const auto& node_b = second.node(b);
  if (node_a.level < node_b.level) {
    const auto bounds = node_a.bounds();
    for (auto mask = node_b.meeting(bounds); mask != 0; mask &= mask - 1) {
      const auto j = static_cast<std::size_t>(std::countr_zero(mask));
      visit_pairs_below(first, a, second, node_b.child[j], add);
    }
    return;
  }
  if (node_a.level > node_b.level) {
    const auto bounds = node_b.bounds();
    for (auto mask = node_a.meeting(bounds); mask != 0; mask &= mask - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(mask));
      visit_pairs_below(first, node_a.child[i], second, b, add);
    }
    return;
  }
  for (auto rows = node_a.meeting(node_b.bounds()); rows != 0; rows &= rows - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(rows));
    for (auto mask = node_b.meeting(node_a.box(i)); mask != 0; mask &= mask - 1) {
      const auto j = static_cast<std::size_t>(std::countr_zero(mask));
      if (node_a.level == 0) {
        add(node_a.child[i], node_b.child[j]);
      } else {
        visit_pairs_below(first, node_a.child[i], second, node_b.child[j], add);
      }
    }
  }
}

/// Calls add(a, b) once for each pair of objects below node `at` whose boxes overlap.
template <class Tree, class Add>
constexpr void visit_pairs(const Tree& tree, std::uint32_t at, const Add& add) {
  const auto& node = tree.node(at);
  if (node.level > 0) {
    for (std::size_t i = 0; i < node.count; ++i) prefetch(&tree.node(node.child[i]), sizeof(node));
  }
  for (std::size_t i = 0; i < node.count; ++i) {
    if (node.level > 0) visit_pairs(tree, node.child[i], add);
    const auto later = node.meeting(node.box(i)) & ~((2u << i) - 1);
    for (auto mask = later; mask != 0; mask &= mask - 1) {
      const auto j = static_cast<std::size_t>(std::countr_zero(mask));
      if (node.level == 0) {
        add(node.child[i], node.child[j]);
      } else {
        visit_pairs_below(tree, node.child[i], tree, node.child[j], add);
      }
    }
  }
}

}  // namespace detent::detail
