// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "detent/query/kernel/box_filter.hpp"

namespace detent::detail {

/// Filter: whether a box meets a triangle with these corners, given relative to its center. It uses
/// projections onto the axes of the box, truncated by less than one step (docs/filters.md, lemma
/// 6): the axes decide, or the projections serve as coordinates.
template <Scalar S, Number H, Number T>
[[nodiscard]] constexpr Filtered decide_box_meets_triangle(
    const AxisFrame<S, 3>& box, const Vec<H, 3>& half_extents,
    const std::array<Vec<T, 3>, 3>& corners) noexcept {
  if (!is_square(box)) return Filtered::unsure;
  using Place = Fixed<34, T::frac>;
  const Place error = box_error(half_extents.x + half_extents.y + half_extents.z);
  std::array<Vec<Place, 3>, 3> places;
  std::array<bool, 3> within{true, true, true};
  for (int i = 0; i < 3; ++i) {
    const Place most = narrow_sum<34>(half_extents[i], error);
    const Place least = narrow_difference<34>(half_extents[i], error);
    int above = 0, below = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto place = narrow_floor<Place>(box.along(i, corners[k]));
      above += place > most ? 1 : 0;
      below += place < narrow_negative(most) ? 1 : 0;
      within[k] = within[k] && abs(place) <= least;
      places[k][i] = place;
    }
    if (above == 3 || below == 3) return Filtered::no;
  }
  if (within[0] || within[1] || within[2]) return Filtered::yes;

  constexpr int bits = 29;
  using Coordinate = Fixed<bits, T::frac>;
  constexpr auto corner_error = Coordinate::from_raw(64);
  const auto longer = make_vec<3>([&](int i) { return half_extents[i] + corner_error; });
  const auto shorter = make_vec<3>([&](int i) { return half_extents[i] - corner_error; });
  if (!fits<bits>(places[0]) || !fits<bits>(places[1]) || !fits<bits>(places[2]) ||
      !fits<bits>(longer)) {
    return Filtered::unsure;
  }
  const auto meets = [&](const auto& extents) {
    const auto corner = [&](std::size_t k) { return at_most<bits + 1>(places[k]); };
    return box_meets_triangle<bits + 1>(WorldFrame(), at_most<bits>(extents), corner(0), corner(1),
                                        corner(2));
  };
  if (shorter.x >= 0 && shorter.y >= 0 && shorter.z >= 0 && meets(shorter)) return Filtered::yes;
  return meets(longer) ? Filtered::unsure : Filtered::no;
}

}  // namespace detent::detail
