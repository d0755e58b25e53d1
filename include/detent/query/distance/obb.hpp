// SPDX-License-Identifier: MIT
#pragma once

#include "detent/math/width.hpp"
#include "detent/query/kernel/point_obb.hpp"

namespace detent {

/// The squared distance from `point` to `box`, 0 inside, measured in the frame of the box: the sum
/// of the squares of the excess of |dot(axis(i), point - center)| over half_extents[i].
///
/// It equals the world distance if the axes are orthonormal.
///
/// domain: every input; an empty box gives the greatest number of the result's type
/// exact:  always                                                (tests/oracle/point_obb.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr auto squared_distance(const Obb<S, N>& box,
                                              const Vec<S, N>& point) noexcept {
  using Squared = decltype(squared_length(detail::excess(box, point)));
  return is_empty(box) ? largest<Squared> : squared_length(detail::excess(box, point));
}

namespace detail {

/// The distance from `point` to a nonempty `box` in its frame, rounded down to the grid of T.
template <Number T, Scalar S, int N>
[[nodiscard]] constexpr T gap_in_frame(const Obb<S, N>& box, const Vec<S, N>& point) noexcept {
  // Squares of 62-bit numbers sum to 126 bits.
  return by_width<62>([](const auto& excess) { return sqrt_floor<T>(squared_length(excess)); },
                      excess(box, point));
}

}  // namespace detail

/// The distance from `point` to `box`, 0 inside, measured in the frame of the box.
///
/// units:  world units
/// domain: every input; clamped to the greatest scalar, which is the result for an empty box
/// exact:  rounded down, error in [0, 1) ULP                     (tests/oracle/point_obb.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr S distance(const Obb<S, N>& box, const Vec<S, N>& point) noexcept {
  return is_empty(box) ? largest<S> : detail::gap_in_frame<S>(box, point);
}

}  // namespace detent
