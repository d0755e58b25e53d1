// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "detent/cull/tree/grouping.hpp"
#include "detent/cull/tree/node.hpp"

namespace detent::detail {

/// A dynamic tree of boxes over objects: every leaf is equally deep, and every node except the root
/// has at least three boxes. Its shape depends on its history, so callers sort what they find.
///
/// source: Guttman, R-Trees: A Dynamic Index Structure for Spatial Searching, 1984
template <class Storage, Scalar S, int N>
class Tree {
 public:
  using Node = TreeNode<S, N>;
  using Box = QuantizedBox<S, N>;
  using Area = typename Grid<S>::Area;
  static constexpr std::size_t width = Node::width;
  static constexpr std::size_t least = 3;

  [[nodiscard]] constexpr bool is_empty() const noexcept { return root_ == nowhere; }
  [[nodiscard]] constexpr std::uint32_t root() const noexcept { return root_; }
  [[nodiscard]] constexpr const Node& node(std::uint32_t i) const noexcept { return nodes_[i]; }

  constexpr void reserve(std::size_t objects) { homes_.reserve(objects); }
  constexpr void clear() noexcept {
    nodes_.clear();
    homes_.clear();
    root_ = free_ = nowhere;
    is_in_bulk_ = false;
  }

  /// Rebuilds the tree for the current boxes; the result is better than adding them one by one.
  /// Needs room for all boxes, which a bounded tree takes on the stack.
  ///
  /// source: White and Jain, Similarity Indexing: Algorithms and Performance, 1996 (VAMSplit)
  constexpr void rebuild() {
    if (root_ == nowhere) return;
    typename Storage::template List<Entry, Storage::capacity> entries;
    for (std::uint32_t i = 0; i < homes_.size(); ++i) {
      if (homes_[i] != nowhere) entries.push_back({nodes_[leaf_of(i)].box(place_of(i)), i});
    }
    nodes_.resize(0);
    free_ = nowhere;
    if constexpr (requires { Storage::is_growing; }) {
      typename Storage::template List<CenteredPlace<S, N>, 0> parts;
      parts.reserve(entries.size());
      for (std::uint32_t i = 0; i < entries.size(); ++i) parts.push_back({center(entries[i]), i});
      arrange<S, N>(&parts[0], parts.size());
      const auto unordered = entries;
      for (std::size_t i = 0; i < parts.size(); ++i) entries[i] = unordered[parts[i].place];
    } else {
      arrange<S, N>(&entries[0], entries.size());
    }
    for (int level = 0; level == 0 || entries.size() > 1; ++level) pack(entries, level);
    root_ = entries[0].child;
  }

  /// Between `begin_bulk` and `end_bulk`, moving many objects is cheaper, but queries are not
  /// allowed.
  constexpr void begin_bulk() noexcept { is_in_bulk_ = true; }
  constexpr void end_bulk() noexcept {
    is_in_bulk_ = false;
    if (root_ == nowhere) return;
    Area before{}, after{};
    refit_below(root_, before, after);
    if constexpr (requires { Storage::is_growing; }) {
      if (after > 2 * before) rebuild();
    }
  }

  /// Moves the object between `begin_bulk` and `end_bulk`. Returns false, and leaves it to `set`, if
  /// the object is not in the tree or `box` is empty.
  constexpr bool set_in_bulk(std::uint32_t object, const Box& box) noexcept {
    if (object >= homes_.size() || homes_[object] == nowhere || box.is_empty()) return false;
    nodes_[leaf_of(object)].set(place_of(object), box);
    return true;
  }

  /// Adds or moves the object, or removes it when `box` is empty.
  constexpr void set(std::uint32_t object, const Box& box) {
    if (object >= homes_.size()) {
      if (box.is_empty()) return;
      const auto old = homes_.size();
      homes_.resize(object + std::size_t{1});
      for (std::size_t i = old; i < homes_.size(); ++i) homes_[i] = nowhere;
    }
    if (homes_[object] == nowhere) {
      if (!box.is_empty()) insert(object, box, 0);
    } else if (box.is_empty()) {
      erase(leaf_of(object), place_of(object));
      homes_[object] = nowhere;
    } else {
      move(object, box);
    }
  }

 private:
  using Entry = TreeEntry<S, N>;

  /// Replaces the entries by nodes that hold eight of them each. If too few are left for the last
  /// node, the last two share them.
  template <class Entries>
  constexpr void pack(Entries& entries, int level) {
    std::size_t made = 0;
    for (std::size_t at = 0; at < entries.size();) {
      const auto left = entries.size() - at;
      const auto count =
          left > width && left < width + least ? left - least : (std::min)(left, width);
      const auto node = make_node(level);
      for (std::size_t i = 0; i < count; ++i) put(node, entries[at + i]);
      at += count;
      entries[made++] = {nodes_[node].bounds(), node};
    }
    entries.resize(made);
  }

  constexpr std::uint32_t leaf_of(std::uint32_t object) const noexcept {
    return homes_[object] / width;
  }
  constexpr std::size_t place_of(std::uint32_t object) const noexcept {
    return homes_[object] % width;
  }

  constexpr void move(std::uint32_t object, const Box& box) {
    const auto home = leaf_of(object);
    Node& leaf = nodes_[home];
    const auto place = place_of(object);
    if (is_in_bulk_) return leaf.set(place, box);
    const auto old = leaf.box(place);
    if (old == box) return;
    if (home != root_ && !is_within(box, bounds_of(home))) {
      leaf.clear(place);
      const auto others = leaf.bounds();
      leaf.child[place] = object;
      leaf.set(place, old);
      // The object moved away from its neighbours: insert it near others.
      if (half_area(hull_of(others, box)) > 2 * (half_area(others) + half_area(box))) {
        erase(home, place);
        insert(object, box, 0);
        return;
      }
    }
    change(home, place, old, box);
  }

  /// The box around all boxes of a node other than the root, as stored in its parent.
  constexpr Box bounds_of(std::uint32_t i) const noexcept {
    const Node& parent = nodes_[nodes_[i].parent];
    return parent.box(parent.place_of(i));
  }

  /// Changes a box of a node, and updates the boxes above. The node's other boxes are read only if
  /// the old box touched a side of the box above and the new one leaves it.
  constexpr void change(std::uint32_t i, std::size_t place, Box old, Box box) noexcept {
    while (true) {
      nodes_[i].set(place, box);
      if (i == root_) return;
      Node& parent = nodes_[nodes_[i].parent];
      place = parent.place_of(i);
      const auto bounds = parent.box(place);
      bool has_left = false;
      for (std::size_t axis = 0; axis < box.low.size(); ++axis) {
        has_left |= (old.low[axis] == bounds.low[axis] && box.low[axis] > old.low[axis]) ||
                    (old.high[axis] == bounds.high[axis] && box.high[axis] < old.high[axis]);
      }
      box = has_left ? nodes_[i].bounds() : hull_of(bounds, box);
      if (box == bounds) return;
      old = bounds;
      i = nodes_[i].parent;
    }
  }

  /// Recomputes all boxes below `i`, except those of objects, and sums their areas before and
  /// after.
  constexpr void refit_below(std::uint32_t i, Area& before, Area& after) noexcept {
    Node& node = nodes_[i];
    if (node.level == 0) return;
    for (std::size_t k = 0; k < node.count; ++k) {
      const auto old = node.box(k);
      refit_below(node.child[k], before, after);
      const auto box = nodes_[node.child[k]].bounds();
      node.set(k, box);
      // Scaled down so that the sums fit.
      before += half_area(old) / (Area(1) * 65536);
      after += half_area(box) / (Area(1) * 65536);
    }
  }

  /// Updates the boxes above `i`.
  constexpr void refit(std::uint32_t i) noexcept {
    if (i == root_) return;
    const auto parent = nodes_[i].parent;
    const auto place = nodes_[parent].place_of(i);
    const auto old = nodes_[parent].box(place), bounds = nodes_[i].bounds();
    if (old != bounds) change(parent, place, old, bounds);
  }

  /// Adds a box to a node of this level. On the way there, the boxes above grow to hold it.
  constexpr void insert(std::uint32_t child, const Box& box, int level) {
    if (root_ == nowhere) root_ = make_node(0);
    auto at = root_;
    while (nodes_[at].level > level) {
      Node& node = nodes_[at];
      const auto place = best_place(node, box);
      node.set(place, hull_of(node.box(place), box));
      at = node.child[place];
    }
    add(at, {box, child});
  }

  /// Adds an entry to a node. The boxes above hold it already.
  constexpr void add(std::uint32_t at, Entry entry) {
    while (nodes_[at].count == width) {
      const auto sibling = split(at, entry);
      const auto parent = at == root_ ? make_node(nodes_[at].level + 1) : nodes_[at].parent;
      if (at == root_) {
        root_ = parent;
        put(root_, {nodes_[at].bounds(), at});
      } else {
        nodes_[parent].set(nodes_[parent].place_of(at), nodes_[at].bounds());
      }
      entry = {nodes_[sibling].bounds(), sibling};
      at = parent;
    }
    put(at, entry);
  }

  constexpr void put(std::uint32_t at, const Entry& entry) noexcept {
    Node& node = nodes_[at];
    node.set(node.count, entry.box);
    node.child[node.count] = entry.child;
    adopt(at, node.count++);
  }

  /// Updates the back-pointer of the entry.
  constexpr void adopt(std::uint32_t at, std::size_t place) noexcept {
    const auto child = nodes_[at].child[place];
    if (nodes_[at].level == 0) {
      homes_[child] = static_cast<std::uint32_t>(at * width + place);
    } else {
      nodes_[child].parent = at;
    }
  }

  /// Splits the boxes of a full node plus one more between it and a new node, at the cut along an
  /// axis that leaves the least area.
  constexpr std::uint32_t split(std::uint32_t at, const Entry& extra) {
    std::array<Entry, width + 1> entries;
    for (std::size_t i = 0; i < width; ++i) entries[i] = {nodes_[at].box(i), nodes_[at].child[i]};
    entries[width] = extra;
    const auto count = cut_in_two(entries, least);
    const auto sibling = make_node(nodes_[at].level);
    for (std::size_t i = 0; i < width; ++i) nodes_[at].clear(i);
    nodes_[at].count = 0;
    for (std::size_t i = 0; i < entries.size(); ++i) put(i < count ? at : sibling, entries[i]);
    return sibling;
  }

  /// Removes a box from a node. A node with too few left is freed and its boxes are inserted again.
  constexpr void erase(std::uint32_t at, std::size_t place) {
    Node& node = nodes_[at];
    const auto last = static_cast<std::size_t>(--node.count);
    node.set(place, node.box(last));
    node.child[place] = node.child[last];
    node.clear(last);
    if (place != last) adopt(at, place);
    if (at == root_) {
      shrink_root();
    } else if (node.count >= least) {
      refit(at);
    } else {
      std::array<Entry, least> left;
      const std::size_t count = node.count;
      for (std::size_t i = 0; i < count; ++i) left[i] = {node.box(i), node.child[i]};
      const int level = node.level;
      const auto parent = node.parent;
      free_node(at);
      erase(parent, nodes_[parent].place_of(at));
      for (std::size_t i = 0; i < count; ++i) insert(left[i].child, left[i].box, level);
    }
  }

  constexpr void shrink_root() noexcept {
    while (root_ != nowhere && nodes_[root_].count <= (nodes_[root_].level > 0 ? 1 : 0)) {
      const auto old = root_;
      root_ = nodes_[old].level > 0 ? nodes_[old].child[0] : nowhere;
      if (root_ != nowhere) nodes_[root_].parent = nowhere;
      free_node(old);
    }
  }

  constexpr std::uint32_t make_node(int level) {
    std::uint32_t i = free_;
    if (i == nowhere) {
      i = static_cast<std::uint32_t>(nodes_.size());
      nodes_.push_back(Node());
    } else {
      free_ = nodes_[i].parent;
      nodes_[i] = Node();
    }
    nodes_[i].level = static_cast<std::uint16_t>(level);
    return i;
  }

  constexpr void free_node(std::uint32_t i) noexcept {
    nodes_[i].parent = free_;
    free_ = i;
  }

  // Leaves hold three objects or more, so there are at most a third as many leaves as objects, and
  // so on upward. The root may have fewer, and so may one node per level that a removal is about to
  // free.
  typename Storage::template List<Node, Storage::capacity / 2 + 2> nodes_;
  // For each object: leaf * width + its index in the leaf.
  typename Storage::template List<std::uint32_t, Storage::capacity> homes_;
  std::uint32_t root_ = nowhere;
  std::uint32_t free_ = nowhere;
  bool is_in_bulk_ = false;
};

}  // namespace detent::detail
