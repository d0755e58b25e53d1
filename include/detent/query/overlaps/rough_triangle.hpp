// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "detent/query/overlaps/rough_boxes.hpp"

namespace detent::detail {

/// What the axes of a box tell of a triangle with these corners, seen from its center, in 64 bits:
/// apart where they all lie beyond one side, near where one corner lies within all.
///
/// Places along the axes are cut off, by less than one step. Where two axes are perpendicular within
/// 2^-26, a box reaches along each its own half extent and at most 2^-25 H more, for the sum H of
/// all; and a corner with places c has the coordinates c within 2^-23 H. The margin is more.
template <Scalar S, Number H, Number T>
[[nodiscard]] constexpr Nearness roughly_box_meets_triangle(
    const RoughFrame<S>& box, const Vec<H, 3>& half_extents,
    const std::array<Vec<T, 3>, 3>& corners) noexcept {
  if (!is_square(box)) return Nearness::unknown;
  using Place = Fixed<34, T::frac>;
  const Place margin = narrow<34>(
      scale_down<34>(half_extents.x + half_extents.y + half_extents.z, 18) + Place::from_raw(8));
  std::array<bool, 3> within{true, true, true};
  for (int i = 0; i < 3; ++i) {
    const Place most = narrow_sum<34>(half_extents[i], margin);
    const Place least = narrow_difference<34>(half_extents[i], margin);
    int above = 0, below = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto place = narrow_floor<Place>(box.along(i, corners[k]));
      above += place > most ? 1 : 0;
      below += place < narrow_negative(most) ? 1 : 0;
      within[k] = within[k] && abs(place) <= least;
    }
    if (above == 3 || below == 3) return Nearness::apart;
  }
  return within[0] || within[1] || within[2] ? Nearness::near : Nearness::unknown;
}

}  // namespace detent::detail
