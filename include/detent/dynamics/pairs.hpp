// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <compare>
#include <cstddef>
#include <cstdint>

#include "detent/dynamics/local.hpp"

namespace detent::detail {

/// Two bodies by index, the lower one first.
struct BodyPair {
  std::uint32_t a = 0, b = 0;
  [[nodiscard]] friend constexpr auto operator<=>(const BodyPair&,
                                                  const BodyPair&) noexcept = default;
};

/// The bodies of a contact.
template <class Contact>
[[nodiscard]] constexpr BodyPair pair_of(const Contact& contact) noexcept {
  return {contact.a, contact.b};
}

/// A body in the sweep for pairs.
template <Scalar S, int N>
struct SweepEntry {
  BodyBox<S, N> bounds{};
  std::uint32_t body = 0;
};

/// Calls found(pair) for all pairs of bodies whose bounds overlap, in no particular order: a sweep
/// along the x axis. Sorts `bodies`.
template <Scalar S, int N, class Found>
constexpr void sweep(SweepEntry<S, N>* bodies, std::size_t count, const Found& found) noexcept {
  std::sort(bodies, bodies + count, [](const auto& p, const auto& q) {
    if (p.bounds.least.x != q.bounds.least.x) return p.bounds.least.x < q.bounds.least.x;
    return p.body < q.body;
  });
  for (std::size_t i = 0; i < count; ++i) {
    const auto& first = bodies[i];
    for (std::size_t j = i + 1; j < count; ++j) {
      const auto& second = bodies[j];
      if (second.bounds.least.x > first.bounds.most.x) break;
      bool overlap = true;
      for (int k = 1; k < N; ++k) {
        overlap = overlap && second.bounds.least[k] <= first.bounds.most[k] &&
                  first.bounds.least[k] <= second.bounds.most[k];
      }
      if (!overlap) continue;
      found(first.body < second.body ? BodyPair{first.body, second.body}
                                     : BodyPair{second.body, first.body});
    }
  }
}

}  // namespace detent::detail
