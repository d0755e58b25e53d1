// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "detent/query/intersects/aabb.hpp"

namespace detent::detail {

/// Whether `segment` may touch what is in `box`: exactly as `intersects` in fixed point, with a
/// margin for rounding in floating point.
template <Scalar S, int N>
[[nodiscard]] constexpr bool may_cross(const Segment<S, N>& segment,
                                       const Aabb<S, N>& box) noexcept {
  if constexpr (is_fixed<S>) {
    return intersects(segment, box);
  } else {
    S reach{};
    for (int i = 0; i < N; ++i) {
      reach = (std::max)(
          {reach, abs(segment.start[i]), abs(segment.end[i]), abs(box.min[i]), abs(box.max[i])});
    }
    const S margin = reach / (1 << 18);
    const auto grown = make_vec<N>([&](int) { return margin; });
    return intersects(segment, Aabb<S, N>{box.min - grown, box.max + grown});
  }
}

}  // namespace detent::detail
