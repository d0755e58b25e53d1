// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>

#include "detent/cull/bins.hpp"
#include "detent/cull/lanes.hpp"
#include "detent/cull/static_tree/node.hpp"

namespace detent {

namespace detail {

/// A box as numbers that all decrease when it grows: its least coordinates, and the greatest ones
/// `reversed`.
template <Scalar S, int N>
class GrowingBox {
  static constexpr std::size_t axes = N;

 public:
  constexpr GrowingBox() noexcept : GrowingBox(no_box<Aabb<S, N>>) {}
  explicit constexpr GrowingBox(const Aabb<S, N>& box) noexcept {
    for (std::size_t i = 0; i < axes; ++i) {
      sides_[i] = box.min[static_cast<int>(i)];
      sides_[4 + i] = detent::reversed(box.max[static_cast<int>(i)]);
    }
  }
  /// From lanes that hold least coordinates and, from lane 4 on, reversed greatest ones.
  explicit GrowingBox(const Lanes<std::int32_t>& lanes) noexcept {
    std::array<std::int32_t, 8> sides;
    lanes.store(sides);
    sides_ = std::bit_cast<std::array<S, 8>>(sides);
  }
  constexpr void grow(const GrowingBox& other) noexcept { lower(sides_, other.sides_); }

  [[nodiscard]] constexpr S least(int axis) const noexcept {
    return sides_[static_cast<std::size_t>(axis)];
  }
  [[nodiscard]] constexpr S greatest(int axis) const noexcept {
    return detent::reversed(sides_[4 + static_cast<std::size_t>(axis)]);
  }
  [[nodiscard]] constexpr Aabb<S, N> box() const noexcept {
    return {make_vec<N>([&](int i) { return least(i); }),
            make_vec<N>([&](int i) { return greatest(i); })};
  }

 private:
  // Aligned, so that vectors do not cross cache lines.
  alignas(has_lanes ? 32 : alignof(S)) std::array<S, 8> sides_{};
};

/// The expected cost of a box for a ray, up to a factor that all parts of a whole share: the number
/// of items times half the box's surface (in 2D half its perimeter). The chance that a ray near the
/// box hits it is proportional to the surface.
template <Scalar S, int N>
class BoxCost {
  using Size = decltype(S() - S());

 public:
  constexpr BoxCost() noexcept : quantized_(Size()) {}
  explicit constexpr BoxCost(const GrowingBox<S, N>& whole) noexcept : quantized_(longest(whole)) {}

  [[nodiscard]] constexpr auto operator()(const GrowingBox<S, N>& box,
                                          std::uint32_t count) const noexcept {
    const auto size = make_vec<N>([&](int i) {
      return quantized_((std::max)(Size(), Size(box.greatest(i) - box.least(i))));
    });
    if constexpr (N == 2) {
      return times(size.x + size.y, count);
    } else {
      return times(size.x * size.y + size.y * size.z + size.z * size.x, count);
    }
  }

 private:
  [[nodiscard]] static constexpr Size longest(const GrowingBox<S, N>& box) noexcept {
    Size most{};
    for (int i = 0; i < N; ++i) most = (std::max)(most, Size(box.greatest(i) - box.least(i)));
    return most;
  }

  QuantizedSize<Size> quantized_;
};

/// Builds the nodes of a tree from the root down, reordering the items as it goes.
template <Scalar S, int N, class Item>
class StaticBuilder {
  using Box = GrowingBox<S, N>;
  using Node = StaticNode<S, N>;
  using Count = std::uint32_t;
  using Cost = decltype(BoxCost<S, N>()(Box(), Count()));

  /// The box of an item and its middle.
  struct Measured {
    Box box, middle;
  };

  /// Whether items are measured with vectors.
  static constexpr bool uses_lanes = has_lanes && requires(const Item& item) {
    lanes_around(item);
  };

  [[nodiscard]] static Measured measured_by_lanes(const Item& item) noexcept {
    const auto lanes = lanes_around(item);
    return {Box(lanes), Box(lanes.middle())};
  }
  [[nodiscard]] static constexpr Measured measured(const Item& item) noexcept {
    if constexpr (uses_lanes) {
      if (!std::is_constant_evaluated()) return measured_by_lanes(item);
    }
    const auto box = bounding_box(item);
    const auto at = make_vec<N>([&](int i) { return mean(box.min[i], box.max[i]); });
    return {Box(box), Box(Aabb<S, N>{at, at})};
  }

  /// A part of the list, with the box around its items and the box around the middles of their
  /// boxes.
  struct Range {
    Box box, middles;
    Count first = 0, count = 0;

    constexpr void add(const Measured& item) noexcept {
      ++count;
      box.grow(item.box);
      middles.grow(item.middle);
    }
  };

 public:
  constexpr StaticBuilder(std::span<Item> items, std::span<Node> nodes) noexcept
      : items_(items), nodes_(nodes) {}

  /// Builds the whole tree; returns the box of all items.
  constexpr Aabb<S, N> build() noexcept {
    const Range all = gathered(0, static_cast<Count>(items_.size()));
    used_ = 1;
    build_node(0, all, 0);
    return all.box.box();
  }

  [[nodiscard]] constexpr std::size_t used() const noexcept { return used_; }

 private:
  /// Builds a node that is `depth` nodes below the root, and all nodes below it.
  ///
  /// If a child of the split by cost would have more items than even splits could still handle, the
  /// node is split evenly instead. So a node never holds more than capacity(depth) items.
  constexpr void build_node(std::size_t place, const Range& range, int depth) noexcept {
    auto [children, used] = split_by_cost(range);
    for (std::size_t i = 0; i < used; ++i) {
      if (children[i].count > capacity(depth + 1)) {
        std::tie(children, used) = split_evenly(range);
        break;
      }
    }
    Node node(range.box.box());
    for (std::size_t i = 0; i < used; ++i) {
      const auto& child = children[i];
      const bool is_leaf = child.count <= StaticTree<S, N>::leaf_size;
      node.add_child(child.box.box(), is_leaf ? child.first : static_cast<Count>(used_++),
                     is_leaf ? child.count : 0);
    }
    nodes_[place] = node;
    for (std::size_t i = 0; i < used; ++i) {
      if (node.count[i] == 0) build_node(node.first[i], children[i], depth + 1);
    }
  }

  /// leaf_size * 8^(static_tree_depth - depth): as many items as even splits below this depth can
  /// divide into leaves.
  [[nodiscard]] static constexpr std::uint64_t capacity(int depth) noexcept {
    return std::uint64_t{StaticTree<S, N>::leaf_size}
           << (std::min)(3 * (static_tree_depth - depth), 48);
  }

  using Children = std::array<Range, Node::width>;

  /// Up to eight parts, made by repeatedly splitting the one that costs most.
  [[nodiscard]] constexpr std::pair<Children, std::size_t> split_by_cost(
      const Range& range) noexcept {
    Children parts;
    parts[0] = range;
    const BoxCost<S, N> cost_of(range.box);
    std::size_t used = 1;
    while (used < Node::width) {
      std::size_t worst = used;
      Cost most{};
      for (std::size_t i = 0; i < used; ++i) {
        if (parts[i].count <= StaticTree<S, N>::leaf_size) continue;
        const Cost cost = cost_of(parts[i].box, parts[i].count);
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

  /// Eight parts whose sizes differ by at most one.
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

  /// A range cut in the middle of the list in its current order.
  [[nodiscard]] constexpr std::pair<Range, Range> halves(const Range& range) const noexcept {
    const Count left = range.count / 2;
    return {gathered(range.first, left), gathered(range.first + left, range.count - left)};
  }
  [[nodiscard]] constexpr Range gathered(Count first, Count count) const noexcept {
    Range range;
    range.first = first;
    for (const auto& item : items_.subspan(first, count)) range.add(measured(item));
    return range;
  }

  struct AxisBins {
    std::array<Box, bin_count> boxes;
    std::array<Count, bin_count> counts{};
  };

  struct Plane {
    int axis = -1;
    std::size_t bin = 0;
    Cost cost{};
  };

  /// Splits a range of two items or more at the plane with the least expected cost, among those
  /// between 16 bins on each axis; ties go to the first. If all items have the same middle, cuts
  /// the list in half. In a long list, a sample of at least 256 items chooses the plane.
  ///
  /// source: Wald, On fast Construction of SAH-based Bounding Volume Hierarchies (2007)
  [[nodiscard]] constexpr std::pair<Range, Range> split(const Range& range) noexcept {
    const auto items = items_.subspan(range.first, range.count);
    const auto bins_of = make_array(
        [&](int i) { return Bins<S>(range.middles.least(i), range.middles.greatest(i)); });
    std::array<AxisBins, std::size_t{N}> bins;
    if (std::is_constant_evaluated()) {
      // Without this loop GCC 12 lets all bins share one box, and keeps its value for the whole
      // program.
      for (auto& axis : bins) {
        for (auto& box : axis.boxes) box = Box();
      }
    }
    const std::size_t stride = std::max<std::size_t>(items.size() / 256, 1);
    for (std::size_t k = 0; k < items.size(); k += stride) {
      const Measured item = measured(items[k]);
      for (int i = 0; i < N; ++i) {
        const auto axis = static_cast<std::size_t>(i);
        const std::size_t bin = bins_of[axis](item.middle.least(i));
        bins[axis].boxes[bin].grow(item.box);
        ++bins[axis].counts[bin];
      }
    }
    Plane best;
    for (int i = 0; i < N; ++i) find_plane(bins[static_cast<std::size_t>(i)], range.box, i, best);
    if (best.axis < 0) return halves(range);
    const auto& bin_of = bins_of[static_cast<std::size_t>(best.axis)];
    return partition(range, [&](const Measured& item) {
      return bin_of(item.middle.least(best.axis)) < best.bin;
    });
  }

  /// Updates `best` with the planes between the bins of an axis.
  static constexpr void find_plane(const AxisBins& bins, const Box& whole, int axis,
                                   Plane& best) noexcept {
    const BoxCost<S, N> cost_of(whole);
    std::array<Cost, bin_count> above{};
    Box box;
    Count count = 0;
    for (std::size_t i = bin_count - 1; i > 0; --i) {
      if (bins.counts[i] == 0) continue;
      count += bins.counts[i];
      box.grow(bins.boxes[i]);
      above[i] = cost_of(box, count);
    }
    // Only planes below a non-empty bin: others split the items like the next one.
    box = bins.boxes[0];
    count = bins.counts[0];
    for (std::size_t i = 1; i < bin_count; ++i) {
      if (bins.counts[i] == 0) continue;
      if (count != 0) {
        const Cost cost = sum_of(cost_of(box, count), above[i]);
        if (best.axis < 0 || cost < best.cost) best = {axis, i, cost};
      }
      count += bins.counts[i];
      box.grow(bins.boxes[i]);
    }
  }

  /// The sum fits: the counts add up to that of the whole, and neither box is larger than the
  /// whole's.
  [[nodiscard]] static constexpr Cost sum_of(const Cost& a, const Cost& b) noexcept {
    return narrow_sum<bits_of<Cost>>(a, b);
  }

  /// Moves the items that pass the test to the front and returns both parts. The new order depends
  /// only on the order before, which std::partition does not promise: the first item that must move
  /// right is swapped with the last one that must move left, and so on inward.
  template <class Test>
  constexpr std::pair<Range, Range> partition(const Range& range, const Test& test) noexcept {
    const auto items = items_.subspan(range.first, range.count);
    if constexpr (uses_lanes) {
      if (!std::is_constant_evaluated()) return partition_in_blocks(range, items, test);
    }
    Range left, right;
    std::size_t first = 0, last = items.size();
    const auto goes_left = [&](const Item& item) {
      const Measured box = measured(item);
      const bool passes = test(box);
      (passes ? left : right).add(box);
      return passes;
    };
    while (true) {
      while (first < last && goes_left(items[first])) ++first;
      // The item at `first` goes to the right, if there is one.
      while (first + 1 < last && !goes_left(items[last - 1])) --last;
      if (first + 1 >= last) break;
      std::swap(items[first++], items[--last]);
    }
    left.first = range.first;
    right.first = range.first + left.count;
    return {left, right};
  }

  /// The same without branches that depend on an item, because those are hard to predict.
  ///
  /// source: Edelkamp and Weiss, BlockQuicksort: Avoiding Branch Mispredictions in Quicksort, 2016
  template <class Test>
  static std::pair<Range, Range> partition_in_blocks(const Range& range, std::span<Item> items,
                                                     const Test& test) noexcept {
    std::array<Range, 2> parts;  // right, left
    for (const Item& item : items) {
      const Measured box = measured(item);
      parts[test(box) ? 1 : 0].add(box);
    }
    auto& [right, left] = parts;
    left.first = range.first;
    right.first = range.first + left.count;
    // Indices of the misplaced items found so far, from both ends inward.
    constexpr std::size_t room = 32;
    std::array<std::size_t, room> in_left{}, in_right{};
    std::size_t first = 0, last = items.size(), left_count = 0, right_count = 0, swapped_left = 0,
                swapped_right = 0;
    while (true) {
      if (left_count == swapped_left) {
        left_count = swapped_left = 0;
        for (const auto end = (std::min)(first + room, std::size_t{left.count}); first < end;
             ++first) {
          in_left[left_count] = first;
          left_count += test(measured(items[first])) ? 0u : 1u;
        }
      }
      if (right_count == swapped_right) {
        right_count = swapped_right = 0;
        for (const auto end = last - (std::min)(last - left.count, room); last > end; --last) {
          in_right[right_count] = last - 1;
          right_count += test(measured(items[last - 1])) ? 1u : 0u;
        }
      }
      const auto count = (std::min)(left_count - swapped_left, right_count - swapped_right);
      for (std::size_t i = 0; i < count; ++i) {
        std::swap(items[in_left[swapped_left++]], items[in_right[swapped_right++]]);
      }
      if (first == left.count && left_count == swapped_left) return {left, right};
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

/// Builds a tree over `items` in `nodes`, which must outlive it, and reorders the items to match.
/// Returns nothing, and touches nothing, if there are fewer than tree_capacity(items.size()) nodes,
/// or 2^32 items or more.
///
/// Each item's box is `bounding_box(item)`. The same items in the same order make the same tree,
/// bit for bit, on every machine.                                (tests/cull/static_tree.test.cpp)
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
