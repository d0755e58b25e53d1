// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "detent/number/require_cxx20.hpp"

namespace detent::detail {

/// Adds `item` to `kept`, of which `seen` were offered before: a list that can hold all takes it;
/// a full one keeps the least of all offered, whatever their order. Sort it at the end.
///
/// A full list is a heap, its greatest item in front.
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

/// Puts what keep_first kept of the `seen` items that it was offered in order.
///
/// By the heap that a full list already is: std::sort looks at 16 items at a time, which GCC takes
/// for an index out of bounds where an array is shorter.
template <class Item>
constexpr void sort_kept(std::span<Item> kept, std::size_t seen) noexcept {
  const auto items = kept.first((std::min)(seen, kept.size()));
  if (seen < kept.size()) std::make_heap(items.begin(), items.end());
  std::sort_heap(items.begin(), items.end());
}

}  // namespace detent::detail
