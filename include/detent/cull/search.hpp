// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

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

  /// The most parts pending in a walk: seven per level.
  static constexpr std::size_t room = 7 * tree_depth;

  [[nodiscard]] constexpr bool is_leaf() const noexcept { return is_object; }
};

/// A ray or a moving box, and the distance within which boxes matter.
template <Scalar S, int N>
class RayProbe {
 public:
  using Limit = typename RaySlab<S>::Time;

  explicit constexpr RayProbe(const Ray<S, N>& ray) noexcept : direction_(ray.direction) {
    for (int i = 0; i < N; ++i) {
      const auto axis = static_cast<std::size_t>(i);
      from_.low[axis] = from_.high[axis] =
          static_cast<typename Grid<S>::Coordinate>(Grid<S>::step(ray.origin[i]));
    }
    shorten(ray.max_distance);
  }
  /// For the moving contents of `box`, which is not empty. Like a ray, it ends within 2^29 steps.
  constexpr RayProbe(const QuantizedBox<S, N>& box, const Direction<S, N>& direction,
                     const S& max_distance) noexcept
      : from_(box), direction_(direction) {
    shorten(max_distance);
  }

  [[nodiscard]] constexpr const QuantizedBox<S, N>& from() const noexcept { return from_; }
  [[nodiscard]] constexpr const Direction<S, N>& direction() const noexcept { return direction_; }
  [[nodiscard]] constexpr Limit limit() const noexcept { return limit_; }
  /// From now on, only boxes that may lie within `distance` matter.
  constexpr void shorten(const S& distance) noexcept { limit_ = Limit{Grid<S>::above(distance)}; }

 private:
  QuantizedBox<S, N> from_;
  Direction<S, N> direction_;
  Limit limit_{};
};

/// Tests one box at a time: whether the probe may reach it, and a lower bound on the time.
template <Scalar S, int N>
class RayKeys {
 public:
  using Key = typename RayProbe<S, N>::Limit;

  explicit constexpr RayKeys(const RayProbe<S, N>& probe) noexcept : probe_(probe) {
    for (std::size_t axis = 0; axis < slabs_.size(); ++axis) {
      slabs_[axis] = RaySlab<S>(probe.from().low[axis], probe.from().high[axis],
                                probe.direction()[static_cast<int>(axis)], Ticks<S>());
    }
  }

  [[nodiscard]] constexpr bool reaches(Key key) const noexcept { return key <= probe_.limit(); }

  constexpr auto keys(const TreeNode<S, N>& node,
                      std::array<Key, TreeNode<S, N>::width>& keys) const noexcept {
    constexpr auto width = TreeNode<S, N>::width;
    std::array<Key, width> exits;
    keys.fill(Key(0));
    exits.fill(probe_.limit());
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
  const RayProbe<S, N>& probe_;
  std::array<RaySlab<S>, static_cast<std::size_t>(N)> slabs_;
};

/// Tests the eight boxes of a node at once.
template <Scalar S, int N, class Lanes>
class RayLanes {
 public:
  using Key = std::int32_t;

  explicit constexpr RayLanes(const RayProbe<S, N>& probe) noexcept
      : probe_(probe),
        reach_(std::clamp<std::int64_t>(probe.limit(), 64, longest)),
        exponent_((std::max)(
            static_cast<int>(std::bit_width(static_cast<std::uint64_t>(reach_))) - 26, 0)) {
    for (std::size_t axis = 0; axis < slabs_.size(); ++axis) {
      slabs_[axis] = Slab(probe.from().low[axis], probe.from().high[axis],
                          probe.direction()[static_cast<int>(axis)], reach_, exponent_);
    }
  }

  [[nodiscard]] constexpr bool reaches(Key key) const noexcept { return key <= limit(); }

  constexpr auto keys(const TreeNode<S, N>& node,
                      std::array<Key, TreeNode<S, N>::width>& keys) const noexcept {
    Lanes in(Key{0}), out(limit());
    for (std::size_t axis = 0; axis < slabs_.size(); ++axis) {
      const Slab& slab = slabs_[axis];
      in.raise(slab.enter((slab.is_backward() ? node.high : node.low)[axis]));
      out.lower(slab.leave((slab.is_backward() ? node.low : node.high)[axis]));
    }
    in.store(keys);
    return in.up_to(out) & ((1u << node.count) - 1);
  }

 private:
  using Slab = LaneSlab<S, Lanes>;
  /// The longest distance, in steps.
  static constexpr std::int64_t longest = std::int64_t{1} << (bits_of<S> - Grid<S>::shift);

  /// In ticks, rounded up.
  [[nodiscard]] constexpr Key limit() const noexcept {
    return static_cast<Key>((std::min<std::int64_t>(probe_.limit(), reach_) >> exponent_) + 1);
  }

  const RayProbe<S, N>& probe_;
  std::int64_t reach_;
  int exponent_;
  std::array<Slab, static_cast<std::size_t>(N)> slabs_;
};

/// Tests which boxes may lie within a distance of a point, and computes their squared distances.
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
  /// A distance measured in the frame of a box may be smaller by 2^-8 (bounds.hpp).
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

/// A tree as traversed by a probe. `Keys` tests boxes for it: the classes above.
template <class Tree, class Keys, class Visit>
struct TreeSearch {
  using Key = typename Keys::Key;
  using Part = TreePart;
  using Node = typename Tree::Node;
  static constexpr std::size_t most_children = Tree::width, room = Part::room;

  const Tree& tree;
  const Keys& keys;
  const Visit& visit;

  [[nodiscard]] constexpr const Node& node(const Part& part) const noexcept {
    return tree.node(part.at);
  }
  [[nodiscard]] constexpr std::uint32_t meets(
      const Node& node, std::array<Key, most_children>& times) const noexcept {
    return keys.keys(node, times);
  }
  [[nodiscard]] constexpr Part child(const Node& node, std::size_t k) const noexcept {
    if (node.level > 0) {
      prefetch(&tree.node(node.child[k]), sizeof(node));
    } else if constexpr (requires { visit.ahead(node.child[k]); }) {
      visit.ahead(node.child[k]);
    }
    return {node.child[k], node.level == 0};
  }
  [[nodiscard]] constexpr bool reaches(const Key& key) const noexcept { return keys.reaches(key); }
};

template <class Tree, class Keys, class Visit>
constexpr Walk visit_nearest_by(const Tree& tree, const Keys& keys, const Visit& visit) {
  return visit_nearest_first({tree.root(), false}, TreeSearch<Tree, Keys, Visit>{tree, keys, visit},
                             [&](const TreePart& object) { return visit(object.at); });
}

/// Visits the objects whose boxes `probe` reaches, nearer boxes first: calls visit(object), which may
/// shorten the probe.
template <class Tree, Scalar S, int N, class Visit>
constexpr Walk visit_nearest(const Tree& tree, const PointProbe<S, N>& probe, const Visit& visit) {
  if (tree.is_empty()) return Walk::go_on;
  return visit_nearest_by(tree, probe, visit);
}
template <class Tree, Scalar S, int N, class Visit>
constexpr Walk visit_nearest(const Tree& tree, const RayProbe<S, N>& probe, const Visit& visit) {
  if (tree.is_empty()) return Walk::go_on;
  if constexpr (is_fixed<S> && has_full_lanes) {
    if (!__builtin_is_constant_evaluated()) {
      return visit_nearest_by(tree, RayLanes<S, N, ComparedLanes<std::int32_t>>(probe), visit);
    }
  }
  return visit_nearest_by(tree, RayKeys<S, N>(probe), visit);
}

/// The most objects that `visit_meeting` collects before it visits them.
inline constexpr std::size_t most_waiting = 24;

/// Visits the objects whose boxes overlap `box`: calls visit(objects) with a list of them whenever
/// more than `most` <= most_waiting are collected, and at the end. Visiting many together is
/// faster: collecting needs no branches on how many children overlap, which is unpredictable, and
/// gives the prefetch of their records time.
template <class Tree, class Visit>
constexpr Walk visit_meeting(const Tree& tree, const typename Tree::Box& box, std::size_t most,
                             const Visit& visit) {
  if (tree.is_empty() || box.is_empty()) return Walk::go_on;
  // With room for eight more, because `pack_children` may write that many.
  std::array<std::uint32_t, TreePart::room + Tree::width> nodes;
  std::array<std::uint32_t, most_waiting + Tree::width> objects;
  std::size_t size = 0, found = 0;
  nodes[size++] = tree.root();
  while (size > 0) {
    const auto& node = tree.node(nodes[--size]);
    const bool is_leaf = node.level == 0;
    const auto count =
        node.pack_children(node.meeting(box), is_leaf ? &objects[found] : &nodes[size]);
    size += is_leaf ? 0 : count;
    found += is_leaf ? count : 0;
    if (found > most || size == 0) {
      if (visit(std::span<const std::uint32_t>(objects.data(), found)) == Walk::stop) {
        return Walk::stop;
      }
      found = 0;
    }
  }
  return Walk::go_on;
}

/// A node of a tree, and the box around it, which its parent stores.
template <class Tree>
struct BoxedNode {
  std::uint32_t at;
  typename Tree::Box box;

  [[nodiscard]] static constexpr BoxedNode root(const Tree& tree) noexcept {
    return {tree.root(), tree.node(tree.root()).bounds()};
  }
  [[nodiscard]] static constexpr BoxedNode child(const typename Tree::Node& node,
                                                 std::size_t i) noexcept {
    return {node.child[i], node.box(i)};
  }
};

/// Pairs of objects whose boxes overlap.
struct CandidatePairs {
  std::span<const std::uint32_t> first, second;
};

/// Collects pairs, and calls visit(pairs) with many of them at once.
template <class Visit>
class PairQueue {
 public:
  explicit constexpr PairQueue(const Visit& visit) noexcept : visit_(visit) {}

  /// Adds the pairs of an object and the children of a leaf whose bits are set.
  template <class Node>
  constexpr void add(std::uint32_t object, const Node& leaf, typename Node::Mask others) {
    for (std::size_t i = 0; i < Node::width; ++i) first_[size_ + i] = object;
    size_ += leaf.pack_children(others, &second_[size_]);
    if (size_ > first_.size() - Node::width) flush();
  }
  constexpr void flush() {
    visit_(CandidatePairs{{first_.data(), size_}, {second_.data(), size_}});
    size_ = 0;
  }

 private:
  const Visit& visit_;
  std::array<std::uint32_t, 64> first_, second_;
  std::size_t size_ = 0;
};

/// Adds the pairs of objects with overlapping boxes, one below node `a` of one tree and one below
/// node `b` of another.
template <class Tree, class Queue>
constexpr void add_pairs_below(const Tree& first, const BoxedNode<Tree>& a, const Tree& second,
                               const BoxedNode<Tree>& b, Queue& queue) {
  using Boxed = BoxedNode<Tree>;
  const auto& node_a = first.node(a.at);
  const auto& node_b = second.node(b.at);
  if (node_a.level < node_b.level) {
    for (auto mask = node_b.meeting(a.box); mask != 0; mask &= mask - 1) {
      const auto j = static_cast<std::size_t>(std::countr_zero(mask));
      add_pairs_below(first, a, second, Boxed::child(node_b, j), queue);
    }
    return;
  }
  auto rows = node_a.meeting(b.box);
  if (node_a.level > node_b.level) {
    for (; rows != 0; rows &= rows - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(rows));
      add_pairs_below(first, Boxed::child(node_a, i), second, b, queue);
    }
    return;
  }
  if (node_a.level == 0) {
    for (; rows != 0; rows &= rows - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(rows));
      queue.add(node_a.child[i], node_b, node_b.meeting(node_a.box(i)));
    }
    return;
  }
  for (; rows != 0; rows &= rows - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(rows));
    const auto row = Boxed::child(node_a, i);
    for (auto mask = node_b.meeting(row.box); mask != 0; mask &= mask - 1) {
      const auto j = static_cast<std::size_t>(std::countr_zero(mask));
      add_pairs_below(first, row, second, Boxed::child(node_b, j), queue);
    }
  }
}

/// Adds each pair of objects below node `at` whose boxes overlap, once.
template <class Tree, class Queue>
constexpr void add_pairs(const Tree& tree, std::uint32_t at, Queue& queue) {
  using Boxed = BoxedNode<Tree>;
  const auto& node = tree.node(at);
  const auto later = [&](std::size_t i) { return node.meeting(node.box(i)) & ~((2u << i) - 1); };
  if (node.level == 0) {
    for (std::size_t i = 0; i < node.count; ++i) queue.add(node.child[i], node, later(i));
    return;
  }
  for (std::size_t i = 0; i < node.count; ++i) prefetch(&tree.node(node.child[i]), sizeof(node));
  for (std::size_t i = 0; i < node.count; ++i) {
    add_pairs(tree, node.child[i], queue);
    const auto row = Boxed::child(node, i);
    for (auto mask = later(i); mask != 0; mask &= mask - 1) {
      const auto j = static_cast<std::size_t>(std::countr_zero(mask));
      add_pairs_below(tree, row, tree, Boxed::child(node, j), queue);
    }
  }
}

}  // namespace detent::detail
