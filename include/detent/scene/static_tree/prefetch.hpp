// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <type_traits>

namespace detent::detail {

/// Asks the machine to fetch an array that will be read soon: a hint without an effect.
///
/// A tree of many triangles is larger than the near caches; without the hint, waiting for memory
/// takes a third of the time of a ray through it.
template <class T>
constexpr void prefetch([[maybe_unused]] const T* first,
                        [[maybe_unused]] std::size_t count) noexcept {
#if defined(__GNUC__)
  if (std::is_constant_evaluated()) return;
  constexpr std::size_t line = 64;
  const auto* bytes = reinterpret_cast<const char*>(first);
  for (std::size_t i = 0; i < count * sizeof(T); i += line) __builtin_prefetch(bytes + i);
#endif
}

}  // namespace detent::detail
