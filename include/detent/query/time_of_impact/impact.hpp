// SPDX-License-Identifier: MIT
#pragma once

#include "detent/number/scalar.hpp"

namespace detent {

/// When two moving bodies meet: they are apart at every time before `time`, and at `time` they are
/// at most `distance` apart. If not `is_hit`, the search ended early, and they may or may not meet
/// later; the caller can continue from `time`.
template <Scalar S>
struct Impact {
  direction_component<S> time{};
  S distance{};
  bool is_hit = true;

  [[nodiscard]] friend constexpr bool operator==(const Impact&, const Impact&) noexcept = default;
};

/// Appends to a digest: the fields in order.
template <class D, Scalar S>
constexpr void append(D& digest, const Impact<S>& impact) noexcept {
  digest.add(impact.time, impact.distance, impact.is_hit);
}

}  // namespace detent
