// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>

#include "detent/math/width.hpp"
#include "detent/query/raycast/planar.hpp"

namespace detent::detail {

/// By how much `x` is below `low` (negative) or above `high`.
template <Number X, Number T>
[[nodiscard]] constexpr auto excess(const X& x, const T& low, const T& high) noexcept {
  using Excess = decltype(x - low);
  return x < low ? Excess(x - low) : x > high ? Excess(x - high) : Excess();
}
template <Number X, Number T, int N>
[[nodiscard]] constexpr auto excess(const Vec<X, N>& x, const Vec<T, N>& low,
                                    const Vec<T, N>& high) noexcept {
  return make_vec<N>([&](int i) { return excess(x[i], low[i], high[i]); });
}

/// Whether the point t d, for some t in [0, 1], is within `reach` >= 0 of the box from `low` to
/// `high`.
///
/// Its squared distance from the box is the sum of the squares of its excesses: a convex function
/// f(t) of quadratic pieces, which change where the point enters or leaves a slab. Where f is still
/// falling as it does so, the least is yet to come. So every axis tells on which side of its slab
/// the point is at the least of f; and if those that are not inside it have the excesses
/// g[i] + t d[i], that least is |g x d|^2 / d^2.
template <Number T, Number D, Number R, int N>
[[nodiscard]] constexpr bool is_near_slabs(const Vec<T, N>& low, const Vec<T, N>& high,
                                           const Vec<D, N>& d, const R& reach) noexcept {
  for (int i = 0; i < N; ++i) {
    if (low[i] > reach && low[i] - d[i] > reach) return false;
    if (high[i] < -reach && high[i] - d[i] < -reach) return false;
  }
  const auto squared_reach = square(reach);
  const auto at_start = excess(Vec<T, N>(), low, high), at_end = excess(d, low, high);
  if (dot(d, at_start) >= 0) return squared_length(at_start) <= squared_reach;
  if (dot(d, at_end) <= 0) return squared_length(at_end) <= squared_reach;

  const auto is_falling_at = [&](const T& over, const D& under) {
    return dot(d, excess(over * d, under * low, under * high)) < 0;
  };
  Vec<T, N> g;
  Vec<D, N> speed;
  for (int i = 0; i < N; ++i) {
    const bool rises = d[i] >= 0;
    const auto& enter = rises ? low[i] : high[i];
    const auto& leave = rises ? high[i] : low[i];
    const auto is_past = [&](const T& bound) {
      if (d[i] == 0) return bound < 0;
      return rises ? is_falling_at(bound, d[i])
                   : is_falling_at(narrow_negative(bound), narrow_negative(d[i]));
    };
    if (!is_past(enter)) {
      g[i] = narrow_negative(enter);
    } else if (is_past(leave)) {
      g[i] = narrow_negative(leave);
    } else {
      continue;
    }
    speed[i] = d[i];
  }
  if (is_zero(speed)) return squared_length(g) <= squared_reach;
  const auto area = cross(g, speed);
  if constexpr (N == 2) {
    return square(area) <= squared_reach * squared_length(speed);
  } else {
    return squared_length(area) <= squared_reach * squared_length(speed);
  }
}

}  // namespace detent::detail
