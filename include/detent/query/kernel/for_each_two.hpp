// SPDX-License-Identifier: MIT
#pragma once

#include "detent/number/require_cxx20.hpp"

namespace detent::detail {

/// Calls f(x, y) for every two of the things that `each(g)` passes to g; y comes before x.
template <class Each, class F>
constexpr void for_each_two(const Each& each, const F& f) noexcept {
  int i = 0;
  each([&](const auto& x) {
    int j = 0;
    each([&](const auto& y) {
      if (j++ < i) f(x, y);
    });
    ++i;
  });
}

}  // namespace detent::detail
