// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>

#include "detent/query/intersects/reversed.hpp"
#include "detent/query/kernel/point_obb.hpp"
#include "detent/query/kernel/segment_box.hpp"
#include "detent/shape/segment.hpp"

namespace detent {

/// Whether `segment` has a point in `box`, which is solid, surface included.
///
/// The box is {x : |dot(axis(i), x - center)| <= half_extents[i]} with its axes exactly as stored.
///
/// domain: every input; a box with a negative half extent is empty; equal ends make a point
/// exact:  yes or no exact                                     (tests/oracle/segment_obb.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool intersects(const Segment<S, N>& segment,
                                        const Obb<S, N>& box) noexcept {
  if (is_empty(box)) return false;
  const auto start = detail::in_frame(box, segment.start - box.center);
  const auto end = detail::in_frame(box, segment.end - box.center);
  using Along = std::remove_cvref_t<decltype(start.x)>;
  const auto half_extents = make_vec<N>([&](int i) { return Along(box.half_extents[i]); });
  return detail::segment_meets_box(start, end, half_extents);
}

}  // namespace detent
