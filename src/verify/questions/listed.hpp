// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "verify/noinline.hpp"

namespace detent::verify {

/// The result of a query that writes its first results to a buffer and returns their total number.
/// Some results do not fit the buffer.
template <class T, std::size_t Room>
struct Listed {
  std::array<T, Room> first{};
  std::uint32_t count = 0;

  constexpr Listed() noexcept = default;
  /// `ask(room)` runs the query.
  template <class Ask>
  explicit constexpr Listed(const Ask& ask) noexcept : count(answer_of(ask, std::span<T>(first))) {}

  [[nodiscard]] constexpr std::span<const T> kept() const noexcept {
    return std::span(first).first(std::min<std::size_t>(count, Room));
  }
  [[nodiscard]] friend constexpr bool operator==(const Listed& a, const Listed& b) noexcept {
    const auto ours = a.kept(), theirs = b.kept();
    return a.count == b.count && std::equal(ours.begin(), ours.end(), theirs.begin(), theirs.end());
  }

 private:
  // When gcc 12 sees that the buffer has fewer than 16 entries, it warns about inlined sorting
  // code.
  template <class Ask>
  DETENT_VERIFY_NOINLINE static constexpr std::uint32_t answer_of(const Ask& ask,
                                                                  std::span<T> room) noexcept {
    return static_cast<std::uint32_t>(ask(room));
  }
};
template <class D, class T, std::size_t Room>
constexpr void append(D& digest, const Listed<T, Room>& list) noexcept {
  digest.add(list.count);
  for (const T& item : list.kept()) digest.add(item);
}

/// The first results of `scene.all(query, room, filter)` of type T.
template <class T, std::size_t Room, class Scene, class Query, class Filter>
[[nodiscard]] constexpr Listed<T, Room> list_all(const Scene& scene, const Query& query,
                                                 const Filter& filter) noexcept {
  return Listed<T, Room>([&](std::span<T> room) { return scene.all(query, room, filter); });
}

}  // namespace detent::verify
