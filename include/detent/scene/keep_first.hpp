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

}  // namespace detent::detail
