// SPDX-License-Identifier: MIT
#pragma once

#include "detent/math/vec.hpp"

namespace detent {

/// The points between two ends, both included; equal ends make it a single point.
template <Scalar S, int N>
struct Segment {
  Vec<S, N> start;
  Vec<S, N> end;

  [[nodiscard]] friend constexpr bool operator==(const Segment&, const Segment&) noexcept = default;
};

/// Appends to a digest: the fields in order.
template <class D, Scalar S, int N>
constexpr void append(D& digest, const Segment<S, N>& segment) noexcept {
  digest.add(segment.start, segment.end);
}

template <Scalar S, int N>
Segment(Vec<S, N>, Vec<S, N>) -> Segment<S, N>;

}  // namespace detent
