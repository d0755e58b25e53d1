// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>

#include "detent/math/width.hpp"
#include "detent/query/intersects/reversed.hpp"
#include "detent/query/kernel/segment_box.hpp"
#include "detent/shape/aabb.hpp"
#include "detent/shape/segment.hpp"

namespace detent {

/// Whether `segment` has a point in `box`, which is solid, surface included.
///
/// domain: every input; a box with min > max on some axis is empty; equal ends make a point
/// exact:  yes or no exact                                    (tests/oracle/segment_aabb.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool intersects(const Segment<S, N>& segment,
                                        const Aabb<S, N>& box) noexcept {
  if (is_empty(box)) return false;
  // Doubled, so that the center of the box is on the grid.
  const auto center = box.min + box.max;
  const auto start = segment.start + segment.start - center;
  const auto end = segment.end + segment.end - center;
  using Doubled = std::remove_cvref_t<decltype(start.x)>;
  const auto extents = make_vec<N>([&](int i) { return Doubled(box.max[i] - box.min[i]); });
  return by_width<29>([](const auto&... x) { return detail::segment_meets_box(x...); }, start, end,
                      extents);
}

}  // namespace detent
