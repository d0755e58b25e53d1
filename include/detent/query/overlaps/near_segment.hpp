// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "detent/math/width.hpp"
#include "detent/query/distance/segment.hpp"
#include "detent/query/intersects/segment.hpp"

namespace detent::detail {

/// Whether the point at `w` is within `reach` >= 0 of the segment from 0 to `e`:
/// |w x e|^2 <= reach^2 e^2 beside it.
///
/// source: Ericson, Real-Time Collision Detection, 5.1.2.1
template <Number T, Number W, Number R, int N>
[[nodiscard]] constexpr bool is_near_edge(const Vec<T, N>& e, const Vec<W, N>& w,
                                          const R& reach) noexcept {
  const auto along = dot(w, e);
  const auto whole = squared_length(e);
  if (along <= 0) return squared_length(w) <= square(reach);
  if (along >= whole) return squared_length(w - e) <= square(reach);
  using Product = decltype(squared_length(w) * whole);  // |w x e|^2 <= |w|^2 |e|^2
  return narrow_square<bits_of<Product>>(cross(w, e)) <= square(reach) * whole;
}

/// Whether two lines are closest to each other between the ends of both segments, which lead along
/// `d` from 0 and along `e` from `m`; not asked of parallel ones.
///
/// source: Ericson, Real-Time Collision Detection, 5.1.9
template <Number T, Number M>
[[nodiscard]] constexpr bool are_closest_between_ends(const Vec<T, 3>& d, const Vec<T, 3>& e,
                                                      const Vec<M, 3>& m) noexcept {
  const auto dd = squared_length(d), ee = squared_length(e), de = dot(d, e);
  const auto md = dot(m, d), me = dot(m, e);
  const auto whole = dd * ee - de * de;  // |d x e|^2
  // s d - m - t e is perpendicular to both.
  const auto s = md * ee - me * de, t = md * de - me * dd;
  return whole > 0 && s >= 0 && s <= whole && t >= 0 && t <= whole;
}

/// Whether a plane or line through 0 along two vectors of normal n has the point at `m` within
/// `reach` >= 0: (n . m)^2 <= reach^2 n^2.
template <Number T, Number M, Number R>
[[nodiscard]] constexpr bool is_near_level(const Vec<T, 3>& d, const Vec<T, 3>& e,
                                           const Vec<M, 3>& m, const R& reach) noexcept {
  const auto n = cross(d, e);
  return square(dot(n, m)) <= square(reach) * squared_length(n);
}

/// Whether on some axis the corners of two shapes are farther apart than `reach`; then so are the
/// shapes. Most are, so this is asked before anything that needs long integers.
template <Scalar S, int N, std::size_t A, std::size_t B, Number R>
[[nodiscard]] constexpr bool are_apart(const std::array<Vec<S, N>, A>& a,
                                       const std::array<Vec<S, N>, B>& b, const R& reach) noexcept {
  for (int i = 0; i < N; ++i) {
    S a_low = a[0][i], a_high = a_low, b_low = b[0][i], b_high = b_low;
    for (const auto& corner : a) {
      a_low = std::min(a_low, corner[i]);
      a_high = std::max(a_high, corner[i]);
    }
    for (const auto& corner : b) {
      b_low = std::min(b_low, corner[i]);
      b_high = std::max(b_high, corner[i]);
    }
    if (b_low - a_high > reach || a_low - b_high > reach) return true;
  }
  return false;
}

/// Whether `point` is within `reach` >= 0 of `segment`.
template <Scalar S, int N, Number R>
[[nodiscard]] constexpr bool is_near(const Segment<S, N>& segment, const Vec<S, N>& point,
                                     const R& reach) noexcept {
  return by_width<30>([](const auto&... x) { return is_near_edge(x...); },
                      segment.end - segment.start, point - segment.start, reach);
}

/// Whether two segments have points within `reach` >= 0 of each other: an end of one and the other,
/// or the two points between their ends where their lines are closest.
template <Scalar S, int N, Number R>
[[nodiscard]] constexpr bool is_near(const Segment<S, N>& a, const Segment<S, N>& b,
                                     const R& reach) noexcept {
  if (are_apart(std::array{a.start, a.end}, std::array{b.start, b.end}, reach)) return false;
  if (is_near(a, b.start, reach) || is_near(a, b.end, reach)) return true;
  if (is_near(b, a.start, reach) || is_near(b, a.end, reach)) return true;
  if constexpr (N == 2) {
    return intersects(a, b);
  } else {
    const auto d = a.end - a.start, e = b.end - b.start, m = b.start - a.start;
    return by_width<30>([](const auto&... x) { return are_closest_between_ends(x...); }, d, e, m) &&
           by_width<20>([](const auto&... x) { return is_near_level(x...); }, d, e, m, reach);
  }
}

}  // namespace detent::detail
