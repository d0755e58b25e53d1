// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <type_traits>

#include "detent/math/components.hpp"
#include "detent/math/width.hpp"
#include "detent/number/filter/filtered.hpp"
#include "detent/number/fraction.hpp"

namespace detent::detail {

/// How far `x` is below `low` (negative) or above `high`; 0 between them.
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

/// |a x b|^2.
template <Number A, Number B, int N>
[[nodiscard]] constexpr auto squared_area(const Vec<A, N>& a, const Vec<B, N>& b) noexcept {
  const auto area = cross(a, b);
  if constexpr (N == 2) {
    return square(area);
  } else {
    return squared_length(area);
  }
}

/// Whether on some axis all points t d, t in [0, 1], are farther than `limit` from the box from
/// `low` to `high`.
template <Number T, Number D, Number R, int N>
[[nodiscard]] constexpr bool are_beyond_slabs(const Vec<T, N>& low, const Vec<T, N>& high,
                                              const Vec<D, N>& d, const R& limit) noexcept {
  bool any = false;
  for (int i = 0; i < N; ++i) {
    any = (low[i] > limit && low[i] - d[i] > limit) || any;
    any = (high[i] < -limit && high[i] - d[i] < -limit) || any;
  }
  return any;
}

/// Calls `visit` with the shortest vector from the box from `low` to `high` to the points t d, t in
/// [0, 1], and returns its result. The vector is given as such or, if it is perpendicular to
/// `speed`, as g and `speed`: g - speed (g . speed) / speed^2.
///
/// The squared distance from the box is the sum of the squares of the excesses: a convex, piecewise
/// quadratic function f(t), whose pieces change where the point enters or leaves a slab. If f is
/// still falling there, its minimum comes later. So each axis gives the side of its slab on which
/// the minimum lies. If the axes outside their slabs have the excesses g[i] + t d[i], the minimum
/// is |g x d|^2 / d^2.
template <Number T, Number D, int N, class Visit>
[[nodiscard]] constexpr auto nearest_of_slabs(const Vec<T, N>& low, const Vec<T, N>& high,
                                              const Vec<D, N>& d, const Visit& visit) noexcept {
  const auto at_start = excess(Vec<T, N>(), low, high), at_end = excess(d, low, high);
  if (dot(d, at_start) >= 0) return visit(at_start);
  if (dot(d, at_end) <= 0) return visit(at_end);

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
  if (is_zero(speed)) return visit(g);
  return visit(g, speed);
}

/// Calls `within` with the least squared distance of the points t d, t in [0, 1], from the box from
/// `low` to `high`, as a number or as a numerator and a denominator, and returns its result.
template <Number T, Number D, int N, class Within>
[[nodiscard]] constexpr auto compare_slabs(const Vec<T, N>& low, const Vec<T, N>& high,
                                           const Vec<D, N>& d, const Within& within) noexcept {
  return nearest_of_slabs(low, high, d, [&](const auto& g, const auto&... speed) {
    if constexpr (sizeof...(speed) == 0) {
      return within(squared_length(g));
    } else {
      return within(squared_area(g, speed...), squared_length(speed...));
    }
  });
}

/// The least squared distance of the points t d, t in [0, 1], from the box from `low` to `high`, as
/// a `Fraction`.
template <Number T, Number D, int N>
[[nodiscard]] constexpr auto squared_distance_from_slabs(const Vec<T, N>& low,
                                                         const Vec<T, N>& high,
                                                         const Vec<D, N>& d) noexcept {
  using Over = decltype(squared_area(low, d));
  using Under = decltype(squared_length(d));
  using Result = Fraction<Over, Under>;
  const auto make = [](const auto& over, const auto&... under) {
    if constexpr (sizeof...(under) == 0) {
      return Result{Over(over), Under(1)};
    } else {
      return Result{over, under...};
    }
  };
  return compare_slabs(low, high, d, make);
}

/// Whether the point t d, for some t in [0, 1], is within `reach` >= 0 of the box from `low` to
/// `high`.
template <Number T, Number D, Number R, int N>
[[nodiscard]] constexpr bool within_slabs(const Vec<T, N>& low, const Vec<T, N>& high,
                                          const Vec<D, N>& d, const R& reach) noexcept {
  const auto squared_reach = square(reach);
  return !are_beyond_slabs(low, high, d, reach) &&
         compare_slabs(low, high, d, [&](const auto& over, const auto&... under) {
           return over <= (squared_reach * ... * under);
         });
}

/// Filter for `within_slabs` on the leading 28 bits of all numbers (docs/filters.md, lemma 7).
template <Number T, Number D, Number R, int N>
[[nodiscard]] constexpr Filtered decide_within_slabs(const Vec<T, N>& low, const Vec<T, N>& high,
                                                     const Vec<D, N>& d, const R& reach) noexcept {
  constexpr int kept = 28, bits = kept + 1;  // room for a few steps more
  int dropped = bits_of<R> - headroom(reach);
  for (int i = 0; i < N; ++i) {
    dropped = (std::max)(dropped, bits_of<T> - headroom(low[i]));
    dropped = (std::max)(dropped, bits_of<T> - headroom(high[i]));
    dropped = (std::max)(dropped, bits_of<D> - headroom(d[i]));
  }
  dropped = (std::max)(dropped - kept, 0);
  const auto cut = [&](const auto& v) {
    return make_vec<N>([&](int i) { return scale_down<bits>(v[i], dropped); });
  };
  using Reach = Fixed<bits, R::frac>;
  const Approximate cut_reach{Reach(scale_down<bits>(reach, dropped)), Reach::from_raw(5)};
  const auto least = narrow<bits>(cut_reach.value - cut_reach.error);
  const auto most = narrow<bits>(cut_reach.value + cut_reach.error);
  const auto least_square = square(least), most_square = square(most);
  const auto cut_low = cut(low), cut_high = cut(high);
  const auto cut_d = cut(d);
  if (are_beyond_slabs(cut_low, cut_high, cut_d, most)) return Filtered::no;
  return compare_slabs(cut_low, cut_high, cut_d, [&](const auto& over, const auto&... under) {
    if (over > (most_square * ... * under)) return Filtered::no;
    return least >= 0 && over <= (least_square * ... * under) ? Filtered::yes : Filtered::unsure;
  });
}

}  // namespace detent::detail
