// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "detent/scene/static_tree/node.hpp"

namespace detent::detail {

/// The nodes and leaves that are still to be visited, the nearest on top: `Key` says how near.
///
/// What a node at depth d leaves here are at most seven siblings for each level above and its own
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

  /// Puts an entry on top, or below those put there since `base` that are nearer.
  constexpr void insert(std::size_t base, const Entry& entry) noexcept {
    std::size_t place = used_++;
    for (; place > base && entries_[place - 1].key < entry.key; --place) {
      entries_[place] = entries_[place - 1];
    }
    entries_[place] = entry;
  }

 private:
  std::array<Entry, 7 * (static_tree_depth - 1) + 8> entries_;  // each set when it is put there
  std::size_t used_ = 0;
};

}  // namespace detent::detail
