// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "detent/number/require_cxx20.hpp"

namespace detent::detail {

/// Offers `item` to `kept`, after `seen` others. A list with room takes it; a full list keeps the
/// least of all items offered, whatever their order. Call sort_kept at the end.
///
/// A full list is a heap with its greatest item in front.
template <class Item>
constexpr void keep_first(std::span<Item> kept, std::size_t seen, const Item& item) noexcept {
  if (seen < kept.size()) {
    kept[seen] = item;
    if (seen + 1 == kept.size()) std::make_heap(kept.begin(), kept.end());
  } else if (!kept.empty() && item < kept.front()) {
    std::pop_heap(kept.begin(), kept.end());
    kept.back() = item;
    std::push_heap(kept.begin(), kept.end());
  }
}

/// Sorts the items that keep_first kept of the `seen` items offered.
///
/// A full list already is a heap. std::sort looks at 16 items at a time, for which GCC warns of an
/// index out of bounds if an array is shorter.
template <class Item>
constexpr void sort_kept(std::span<Item> kept, std::size_t seen) noexcept {
  const auto items = kept.first((std::min)(seen, kept.size()));
  if (items.size() <= 12) {  // a heap takes longer
    for (std::size_t i = 1; i < items.size(); ++i) {
      const Item item = items[i];
      std::size_t place = i;
      for (; place > 0 && item < items[place - 1]; --place) items[place] = items[place - 1];
      items[place] = item;
    }
    return;
  }
  if (seen < kept.size()) std::make_heap(items.begin(), items.end());
  std::sort_heap(items.begin(), items.end());
}

}  // namespace detent::detail
