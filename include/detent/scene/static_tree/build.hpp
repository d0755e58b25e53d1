// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

#include "detent/number/bins.hpp"
#include "detent/scene/static_tree/node.hpp"

namespace detent {

namespace detail {

/// Half of a box's surface; half of its outline in 2D. A ray that passes near the box meets it in
/// proportion to this.
template <Scalar S, int N>
[[nodiscard]] constexpr auto half_surface(const Aabb<S, N>& box) noexcept {
  const auto size = box.max - box.min;
  if constexpr (N == 2) {
    using Sum = decltype(size.x + size.y);
    return is_empty(box) ? Sum() : size.x + size.y;
  } else {
    using Sum = decltype(size.x * size.y + size.y * size.z + size.z * size.x);
    return is_empty(box) ? Sum() : size.x * size.y + size.y * size.z + size.z * size.x;
  }
}

/// Builds the nodes of a tree from the root down, sorting the items as it goes.
template <Scalar S, int N, class Item>
class StaticBuilder {
  using Box = Aabb<S, N>;
  using Node = StaticNode<S, N>;
  using Count = std::uint32_t;
  using Cost = decltype(times(half_surface(Box()), Count()));

  struct Range {
    Count first = 0, count = 0;
    Box box = no_box<Box>;
  };

 public:
  constexpr StaticBuilder(std::span<Item> items, std::span<Node> nodes) noexcept
      : items_(items), nodes_(nodes) {}

  /// Builds all; returns the box of everything.
  constexpr Box build() noexcept {
    Range all{0, static_cast<Count>(items_.size()), no_box<Box>};
    for (const auto& item : items_) grow(all.box, bounding_box(item));
    used_ = 1;
    build_node(0, all, 0);
    return all.box;
  }

  [[nodiscard]] constexpr std::size_t used() const noexcept { return used_; }

 private:
  /// The children of a node that is `depth` nodes below the root.
  ///
  /// Where a child of an uneven split would have more items than halving could still tame, the
  /// node is split evenly instead: so a node at a depth never holds more than capacity(depth).
  constexpr void build_node(std::size_t place, const Range& range, int depth) noexcept {
    auto [children, used] = split_by_cost(range);
    for (std::size_t i = 0; i < used; ++i) {
      if (children[i].count > capacity(depth + 1)) {
        std::tie(children, used) = split_evenly(range);
        break;
      }
    }
    Node node(range.box);
    for (std::size_t i = 0; i < used; ++i) {
      const auto& child = children[i];
      const bool is_leaf = child.count <= StaticTree<S, N>::leaf_size;
      node.add_child(child.box, is_leaf ? child.first : static_cast<Count>(used_++),
                     is_leaf ? child.count : 0);
    }
    nodes_[place] = node;
    for (std::size_t i = 0; i < used; ++i) {
      if (node.count[i] == 0) build_node(node.first[i], children[i], depth + 1);
    }
  }

  /// leaf_size * 8^(static_tree_depth - depth): what even splits divide into leaves by then.
  [[nodiscard]] static constexpr std::uint64_t capacity(int depth) noexcept {
    return std::uint64_t{StaticTree<S, N>::leaf_size}
           << std::min(3 * (static_tree_depth - depth), 48);
  }

  using Children = std::array<Range, Node::width>;

  /// Up to eight parts, made by splitting the one that costs most.
  [[nodiscard]] constexpr std::pair<Children, std::size_t> split_by_cost(
      const Range& range) noexcept {
    Children parts;
    parts[0] = range;
    std::size_t used = 1;
    while (used < Node::width) {
      std::size_t worst = used;
      Cost most{};
      for (std::size_t i = 0; i < used; ++i) {
        if (parts[i].count <= StaticTree<S, N>::leaf_size) continue;
        const auto cost = times(half_surface(parts[i].box), parts[i].count);
        if (worst == used || cost > most) {
          worst = i;
          most = cost;
        }
      }
      if (worst == used) break;
      std::tie(parts[worst], parts[used]) = split(parts[worst]);
      ++used;
    }
    return {parts, used};
  }

  /// Eight parts of equal size, within one.
  [[nodiscard]] constexpr std::pair<Children, std::size_t> split_evenly(
      const Range& range) noexcept {
    Children parts;
    parts[0] = range;
    for (std::size_t used = 1; used < Node::width; used *= 2) {
      for (std::size_t i = 0; i < used; ++i) {
        std::tie(parts[i], parts[used + i]) = halves(parts[i]);
      }
    }
    return {parts, Node::width};
  }

  /// A range cut in the middle of the list as it stands.
  [[nodiscard]] constexpr std::pair<Range, Range> halves(const Range& range) const noexcept {
    return cut(range, range.count / 2);
  }
  [[nodiscard]] constexpr std::pair<Range, Range> cut(const Range& range,
                                                      Count left) const noexcept {
    return {boxed(range.first, left), boxed(range.first + left, range.count - left)};
  }
  [[nodiscard]] constexpr Range boxed(Count first, Count count) const noexcept {
    Range range{first, count, no_box<Box>};
    for (const auto& item : items_.subspan(first, count)) grow(range.box, bounding_box(item));
    return range;
  }

  static constexpr void grow(Box& box, const Box& other) noexcept {
    for (int i = 0; i < N; ++i) {
      box.min[i] = std::min(box.min[i], other.min[i]);
      box.max[i] = std::max(box.max[i], other.max[i]);
    }
  }

  /// Twice the middle of a box on an axis.
  [[nodiscard]] static constexpr auto middle(const Box& box, int axis) noexcept {
    return box.min[axis] + box.max[axis];
  }
  using Middle = decltype(middle(Box(), 0));

  struct Bin {
    Box box = no_box<Box>;
    Count count = 0;
  };
  using AxisBins = std::array<Bin, bin_count>;

  struct Plane {
    int axis = -1;
    std::size_t bin = 0;
    Cost cost{};
    Range left, right;
  };

  /// Two parts of a range of two items or more: of the planes between 16 bins on each axis the one
  /// with the least expected cost, the first of several; the middle of the list where all items
  /// have the same middle.
  ///
  /// source: Wald, On fast Construction of SAH-based Bounding Volume Hierarchies (2007)
  [[nodiscard]] constexpr std::pair<Range, Range> split(const Range& range) noexcept {
    const auto items = items_.subspan(range.first, range.count);
    Vec<Middle, N> least, greatest;
    for (std::size_t k = 0; k < items.size(); ++k) {
      const Box box = bounding_box(items[k]);
      for (int i = 0; i < N; ++i) {
        const auto x = middle(box, i);
        if (k == 0 || x < least[i]) least[i] = x;
        if (k == 0 || x > greatest[i]) greatest[i] = x;
      }
    }
    const auto bins_of = make_array([&](int i) { return Bins<Middle>(least[i], greatest[i]); });
    std::array<AxisBins, N> bins;
    for (const auto& item : items) {
      const Box box = bounding_box(item);
      for (int i = 0; i < N; ++i) {
        const auto axis = static_cast<std::size_t>(i);
        Bin& bin = bins[axis][bins_of[axis](middle(box, i))];
        grow(bin.box, box);
        ++bin.count;
      }
    }
    Plane best;
    for (int i = 0; i < N; ++i) {
      if (least[i] < greatest[i]) find_plane(bins[static_cast<std::size_t>(i)], range, i, best);
    }
    if (best.axis < 0) return halves(range);
    const auto& bin_of = bins_of[static_cast<std::size_t>(best.axis)];
    partition(items, [&](const Item& item) {
      return bin_of(middle(bounding_box(item), best.axis)) < best.bin;
    });
    return {best.left, best.right};
  }

  /// Improves `best` by the planes between the bins of an axis.
  static constexpr void find_plane(const AxisBins& bins, const Range& range, int axis,
                                   Plane& best) noexcept {
    std::array<Range, bin_count> right;
    Range sum;
    for (std::size_t i = bin_count - 1; i > 0; --i) {
      sum.count += bins[i].count;
      grow(sum.box, bins[i].box);
      right[i] = sum;
    }
    Range left{range.first, 0, no_box<Box>};
    for (std::size_t i = 1; i < bin_count; ++i) {
      left.count += bins[i - 1].count;
      grow(left.box, bins[i - 1].box);
      if (left.count == 0 || right[i].count == 0) continue;
      const Cost cost = sum_of(times(half_surface(left.box), left.count),
                               times(half_surface(right[i].box), right[i].count));
      if (best.axis >= 0 && cost >= best.cost) continue;
      right[i].first = range.first + left.count;
      best = {axis, i, cost, left, right[i]};
    }
  }

  /// Both counts together are one count, and no part is larger than the whole.
  [[nodiscard]] static constexpr Cost sum_of(const Cost& a, const Cost& b) noexcept {
    return narrow_sum<bits_of<Cost>>(a, b);
  }

  /// Moves what passes the test to the front; where the rest ends up depends on nothing else than
  /// the order before, which std::partition does not promise.
  template <class Test>
  static constexpr void partition(std::span<Item> items, const Test& test) noexcept {
    std::size_t first = 0, last = items.size();
    while (true) {
      while (first < last && test(items[first])) ++first;
      while (first < last && !test(items[last - 1])) --last;
      if (first == last) return;
      std::swap(items[first++], items[--last]);
    }
  }

  template <class F>
  static constexpr auto make_array(const F& f) noexcept {
    if constexpr (N == 2) {
      return std::array{f(0), f(1)};
    } else {
      return std::array{f(0), f(1), f(2)};
    }
  }

  std::span<Item> items_;
  std::span<Node> nodes_;
  std::size_t used_ = 0;
};

}  // namespace detail

/// Builds a tree over `items` in `nodes`, which must outlive it, and sorts the items to its order;
/// nothing, and nothing touched, where there are fewer than tree_capacity(items.size()) nodes or
/// 2^32 items.
///
/// `bounding_box(item)` is asked for each item's box. The same items in the same order make the
/// same tree, bit for bit, on every machine.                (tests/scene/tree.test.cpp)
template <Scalar S, int N, class Item>
[[nodiscard]] constexpr std::optional<StaticTree<S, N>> build_tree(
    std::span<Item> items, std::span<StaticNode<S, N>> nodes) noexcept {
  if (items.size() > 0xffffffffu || nodes.size() < tree_capacity(items.size())) return std::nullopt;
  if (items.empty()) return StaticTree<S, N>();
  detail::StaticBuilder<S, N, Item> builder(items, nodes);
  const auto bounds = builder.build();
  return StaticTree<S, N>{nodes.first(builder.used()), bounds};
}

}  // namespace detent
