// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <type_traits>

#include "detent/number/require_cxx20.hpp"

namespace detent::detail {

/// Prefetches bytes that will be read soon: a hint that changes no result.
///
/// A tree over many triangles does not fit the inner caches; without the hint, a ray through it
/// spends a third of its time waiting for memory.
constexpr void prefetch([[maybe_unused]] const void* from,
                        [[maybe_unused]] std::size_t bytes) noexcept {
#if defined(__GNUC__)
  if (std::is_constant_evaluated()) return;
  constexpr std::size_t line = 64;
  for (std::size_t i = 0; i < bytes; i += line) {
    __builtin_prefetch(static_cast<const char*>(from) + i);
  }
#endif
}

}  // namespace detent::detail
