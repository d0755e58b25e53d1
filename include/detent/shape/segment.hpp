// SPDX-License-Identifier: MIT
#pragma once

#include "detent/math/vec.hpp"

namespace detent {

/// The points between two ends, both included; equal ends make it one point.
template <Scalar S, int N>
struct Segment {
  Vec<S, N> start;
  Vec<S, N> end;

  [[nodiscard]] friend constexpr bool operator==(const Segment&, const Segment&) noexcept = default;
};

template <Scalar S, int N>
Segment(Vec<S, N>, Vec<S, N>) -> Segment<S, N>;

}  // namespace detent
