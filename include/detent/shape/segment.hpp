// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "detent/math/vec.hpp"
#include "detent/shape/fields.hpp"

namespace detent {

/// The points between two ends, both included; equal ends make it a single point.
template <Scalar S, int N>
struct Segment {
  Vec<S, N> start;
  Vec<S, N> end;

  [[nodiscard]] friend constexpr bool operator==(const Segment&, const Segment&) noexcept = default;
};

template <Scalar S, int N>
struct detail::ShapeFields<Segment<S, N>> {
  static constexpr std::string_view name = "segment", names[] = {"start", "end"};

  template <class Self, class F>
  static constexpr auto of(Self& segment, const F& f) {
    return f(segment.start, segment.end);
  }
};

template <Scalar S, int N>
Segment(Vec<S, N>, Vec<S, N>) -> Segment<S, N>;

}  // namespace detent
