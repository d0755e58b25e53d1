// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "detent/number/require_cxx20.hpp"

namespace detent::detail {

/// Sets of bodies that touch, directly or through others. `List` holds an index for each body.
template <class List>
class Islands {
 public:
  constexpr void reset(std::size_t bodies) {
    root_.resize(bodies);
    for (std::size_t i = 0; i < bodies; ++i) root_[i] = static_cast<std::uint32_t>(i);
  }

  /// The lowest body of an island.
  [[nodiscard]] constexpr std::uint32_t of(std::uint32_t body) noexcept {
    while (root_[body] != body) {
      root_[body] = root_[root_[body]];
      body = root_[body];
    }
    return body;
  }

  constexpr void join(std::uint32_t a, std::uint32_t b) noexcept {
    a = of(a);
    b = of(b);
    if (a < b) {
      root_[b] = a;
    } else {
      root_[a] = b;
    }
  }

 private:
  List root_;
};

}  // namespace detent::detail
