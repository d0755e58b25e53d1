// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <type_traits>

#include "detent/math/components.hpp"
#include "detent/math/width.hpp"
#include "detent/number/filter/ratio.hpp"
#include "detent/number/fraction.hpp"
#include "detent/shape/segment.hpp"

namespace detent::detail {

/// Whether `point` lies on `segment`, ends included.
template <Scalar S, int N>
[[nodiscard]] constexpr bool holds(const Segment<S, N>& segment, const Vec<S, N>& point) noexcept {
  const auto& [start, end] = segment;
  for (int i = 0; i < N; ++i) {
    if (point[i] < start[i] && point[i] < end[i]) return false;
    if (point[i] > start[i] && point[i] > end[i]) return false;
  }
  return are_parallel(end - start, point - start);
}

/// The squared length of a cross product (a number in 2D); the caller guarantees that it fits
/// `Bits`.
template <int Bits, Number T>
[[nodiscard]] constexpr auto narrow_square(const T& x) noexcept {
  return narrow_product<Bits>(x, x);
}
template <int Bits, Number T, int N>
[[nodiscard]] constexpr auto narrow_square(const Vec<T, N>& x) noexcept {
  return narrow_dot<Bits>(x, x);
}

/// The squared distance from the point `w` to the segment from 0 to `e`.
template <Number T, int N>
[[nodiscard]] constexpr auto squared_distance_from_edge(const Vec<T, N>& e,
                                                        const Vec<T, N>& w) noexcept {
  const auto along = dot(w, e);
  const auto whole = squared_length(e);
  using Under = decltype(squared_length(e));
  // |w x e|^2 <= |w|^2 |e|^2; the sum type also holds |w|^2 if the grid has hardly any integer
  // bits.
  using Product = decltype(whole * whole);
  using Square = decltype(squared_length(w - e));
  using Over = std::conditional_t<std::convertible_to<Square, Product>, Product,
                                  decltype(Product() + Square())>;
  using Result = Fraction<Over, Under>;
  if (along <= 0) return Result{Over(squared_length(w)), Under(1)};
  if (along >= whole) return Result{Over(squared_length(w - e)), Under(1)};
  return Result{narrow_square<bits_of<Over>>(cross(w, e)), whole};
}

/// The distance from the point `w` to the segment from 0 to `e`, rounded down.
template <Number Distance, Number T, int N>
[[nodiscard]] constexpr Distance distance_from_edge(const Vec<T, N>& e,
                                                    const Vec<T, N>& w) noexcept {
  if constexpr (!is_fixed<Distance>) {
    return sqrt_floor<Distance>(squared_distance_from_edge(e, w));
  } else {
    const auto along = dot(w, e);
    const auto whole = squared_length(e);
    if (along <= 0) return sqrt_floor<Distance>(squared_length(w));
    if (along >= whole) return sqrt_floor<Distance>(squared_length(w - e));
    const auto side =
        decide_side_floor<Distance>(squared_length(w), make_ratio_below_one(along, whole));
    return or_exact(side, [&] { return sqrt_floor<Distance>(squared_distance_from_edge(e, w)); });
  }
}

/// `distance` to a segment, in a result type that may differ from its coordinates, without the
/// filter of words.
template <Number Distance, Scalar S, int N>
[[nodiscard]] constexpr Distance any_distance_to(const Segment<S, N>& segment,
                                                 const Vec<S, N>& point) noexcept {
  return by_width<30>([](const auto&... x) { return distance_from_edge<Distance>(x...); },
                      segment.end - segment.start, point - segment.start);
}
template <Number Distance, Scalar S, int N>
[[nodiscard]] DETENT_OUTLINE constexpr Distance outlined_distance_to(
    const Segment<S, N>& segment, const Vec<S, N>& point) noexcept {
  return any_distance_to<Distance>(segment, point);
}

/// `distance` to a segment, in a result type that may differ from its coordinates.
template <Number Distance, Scalar S, int N>
[[nodiscard]] constexpr Distance distance_to(const Segment<S, N>& segment,
                                             const Vec<S, N>& point) noexcept {
  if constexpr (is_fixed<S> && filter_pays<S> && has_long_registers) {
    const auto e = segment.end - segment.start, w = point - segment.start;
    if (fits<30>(e) && fits<30>(w)) [[likely]] {
      const auto distance = decide_segment_distance<Distance>(
          narrow_dot<62>(w, w), narrow_dot<62>(w, e), narrow_dot<62>(e, e));
      if (distance.is_sure) [[likely]]
        return distance.value;
    }
    return outlined_distance_to<Distance>(segment, point);
  } else {
    return any_distance_to<Distance>(segment, point);
  }
}

}  // namespace detent::detail
