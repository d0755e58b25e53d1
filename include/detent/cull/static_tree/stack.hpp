// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "detent/cull/static_tree/node.hpp"

namespace detent::detail {

/// The nodes and leaves still to visit, the nearest on top; `Key` is how near.
///
/// After a node at depth d it holds at most seven siblings for each level above, and the node's
/// eight children: 7 d + 8, and d < static_tree_depth.
template <class Key>
class StaticStack {
 public:
  struct Entry {
    Key key;
    std::uint32_t first;
    std::uint32_t count;
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
  std::array<Entry, 7 * (static_tree_depth - 1) + 8> entries_;  // each set when pushed
  std::size_t used_ = 0;
};

}  // namespace detent::detail
