// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "detent/number/require_cxx20.hpp"

// Walks over trees, height fields and batches find candidates: they visit each item that may
// matter, and possibly others. All have the same contract:
//
// * A walk calls visit(item), or visit(item, limit) if it is ordered by distance. `limit` is the
//   distance beyond which nothing matters any more; visit may lower it, never raise it.
// * visit returns Walk::go_on, or Walk::stop to end the walk.
// * The walk returns Walk::stop if visit did, and Walk::go_on if it reached its end.

namespace detent {

enum class Walk : bool { stop, go_on };

[[nodiscard]] constexpr Walk stop_if(bool is_done) noexcept {
  return is_done ? Walk::stop : Walk::go_on;
}

namespace detail {

/// The key of walks whose order does not matter.
struct Unordered {
  [[nodiscard]] friend constexpr bool operator<(const Unordered&, const Unordered&) noexcept {
    return false;
  }
};

/// The parts still to visit, the nearest of those pushed together on top.
template <class Key, class Part, std::size_t Room>
class NearestStack {
 public:
  struct Entry {
    Key key;
    Part part;
  };

  [[nodiscard]] constexpr bool empty() const noexcept { return used_ == 0; }
  [[nodiscard]] constexpr std::size_t size() const noexcept { return used_; }
  [[nodiscard]] constexpr Entry pop() noexcept { return entries_[--used_]; }

  /// Pushes an entry, below the nearer ones that were pushed since `base`.
  constexpr void insert(std::size_t base, const Entry& entry) noexcept {
    std::size_t place = used_++;
    for (; place > base && entries_[place - 1].key < entry.key; --place) {
      entries_[place] = entries_[place - 1];
    }
    entries_[place] = entry;
  }

 private:
  std::array<Entry, Room> entries_;  // each set when pushed
  std::size_t used_ = 0;
};

/// Walks a tree of parts from `root` to its leaves. The nearest child of a node is next; the others
/// wait. A tree has
///   Key, Part              how near a part is; a node or a leaf, which has is_leaf()
///   most_children, room    the most children of a node, and the most parts that wait
///   node(part)             the node of a part that is no leaf
///   meets(node, keys)      which children matter, a bit for each; sets their keys
///   child(node, k)         child k, as a part
///   reaches(key)           whether a part still matters when its turn comes
template <class Tree, class Visit>
constexpr Walk visit_nearest_first(const typename Tree::Part& root, const Tree& tree,
                                   const Visit& visit) {
  using Key = typename Tree::Key;
  using Stack = NearestStack<Key, typename Tree::Part, Tree::room>;
  Stack stack;
  typename Stack::Entry next{Key{}, root};
  while (true) {
    if (next.part.is_leaf()) {
      if (visit(next.part) == Walk::stop) return Walk::stop;
    } else {
      const auto& node = tree.node(next.part);
      std::array<Key, Tree::most_children> keys;
      std::uint32_t met = tree.meets(node, keys);
      const auto take = [&]() -> typename Stack::Entry {
        const auto k = static_cast<std::size_t>(std::countr_zero(met));
        met &= met - 1;
        return {keys[k], tree.child(node, k)};
      };
      if (met != 0) {
        next = take();
        const std::size_t base = stack.size();
        while (met != 0) {  // NOLINT(bugprone-infinite-loop): take() changes it
          auto other = take();
          if (other.key < next.key) std::swap(next, other);
          stack.insert(base, other);
        }
        continue;
      }
    }
    do {
      if (stack.empty()) return Walk::go_on;
      next = stack.pop();
    } while (!tree.reaches(next.key));
  }
}

}  // namespace detail

}  // namespace detent
