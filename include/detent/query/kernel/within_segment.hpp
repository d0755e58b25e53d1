// SPDX-License-Identifier: MIT
#pragma once

#include "detent/math/width.hpp"
#include "detent/number/filter/leading.hpp"
#include "detent/query/kernel/point_segment.hpp"
#include "detent/query/kernel/segment_segment.hpp"

namespace detent::detail {

/// Whether the point `w` is within `reach` >= 0 of the segment from 0 to `e`: |w x e|^2 <= reach^2
/// e^2 if it projects between the ends.
///
/// source: Ericson, Real-Time Collision Detection, 5.1.2.1
template <Number T, Number W, Number R, int N>
[[nodiscard]] constexpr bool within_edge(const Vec<T, N>& e, const Vec<W, N>& w,
                                         const R& reach) noexcept {
  const auto along = dot(w, e);
  const auto whole = squared_length(e);
  if (along <= 0) return squared_length(w) <= square(reach);
  if (along >= whole) return squared_length(w - e) <= square(reach);
  using Product = decltype(squared_length(w) * whole);  // |w x e|^2 <= |w|^2 |e|^2
  return narrow_square<bits_of<Product>>(cross(w, e)) <= square(reach) * whole;
}

/// Whether the point `m` is within `reach` >= 0 of the plane through 0 with normal n = d x e:
/// (n . m)^2 <= reach^2 n^2. That is also the distance between the lines along `d` through 0 and
/// along `e` through `m`.
template <Number T, Number M, Number R>
[[nodiscard]] constexpr bool within_level(const Vec<T, 3>& d, const Vec<T, 3>& e,
                                          const Vec<M, 3>& m, const R& reach) noexcept {
  const auto n = cross(d, e);
  const auto volume = abs(dot(n, m));
  return compare_products(volume, volume, square(reach), squared_length(n)) <= 0;
}

/// Whether the segments from 0 along `d` and from `m` along `e` come within `reach` >= 0 of each
/// other.
///
/// Tests the points s d and m + t e where their lines are closest, if both are between the ends.
/// Otherwise tests each end that one of them is beyond, as for the minimum of any convex quadratic
/// function over a square; for parallel segments, every end.
///
/// source: Ericson, Real-Time Collision Detection, 5.1.9
template <Number T, Number R>
[[nodiscard]] constexpr bool within_segments(const Vec<T, 3>& d, const Vec<T, 3>& e,
                                             const Vec<T, 3>& m, const R& reach) noexcept {
  const auto dd = squared_length(d), ee = squared_length(e), de = dot(d, e);
  const auto md = dot(m, d), me = dot(m, e);
  const auto whole = dd * ee - de * de;  // |d x e|^2
  // s d - m - t e is perpendicular to both; these are s and t times `whole`.
  const auto s = md * ee - me * de, t = md * de - me * dd;
  if (whole > 0 && s >= 0 && s <= whole && t >= 0 && t <= whole) {
    return within_level(d, e, m, reach);
  }
  const bool any = !(whole > 0);
  return ((any || t < 0) && within_edge(d, m, reach)) ||
         ((any || t > whole) && within_edge(d, m + e, reach)) ||
         ((any || s < 0) && within_edge(e, -m, reach)) ||
         ((any || s > whole) && within_edge(e, d - m, reach));
}

/// The bounding box of some corners.
template <Scalar S, int N>
struct Bounds {
  template <class... Corners>
  explicit constexpr Bounds(const Vec<S, N>& first, const Corners&... others) noexcept
      : low(first), high(first) {
    (include(others), ...);
  }

  Vec<S, N> low, high;

 private:
  constexpr void include(const Vec<S, N>& corner) noexcept {
    low = make_vec<N>([&](int i) { return corner[i] < low[i] ? corner[i] : low[i]; });
    high = make_vec<N>([&](int i) { return corner[i] > high[i] ? corner[i] : high[i]; });
  }
};

/// Whether two bounding boxes are farther apart than `reach` on some axis; then so are their
/// shapes. Most shapes are, so this comes before anything with long integers, and is branchless.
template <Scalar S, int N, Number R>
[[nodiscard]] constexpr bool are_apart(const Bounds<S, N>& a, const Bounds<S, N>& b,
                                       const R& reach) noexcept {
  bool any = false;
  for (int i = 0; i < N; ++i) {
    any = b.low[i] - a.high[i] > reach || any;
    any = a.low[i] - b.high[i] > reach || any;
  }
  return any;
}

/// Whether `point` is within `reach` >= 0 of `segment`.
template <Scalar S, int N, Number R>
[[nodiscard]] constexpr bool within_reach(const Segment<S, N>& segment, const Vec<S, N>& point,
                                          const R& reach) noexcept {
  return by_width<30>([](const auto&... x) { return within_edge(x...); },
                      segment.end - segment.start, point - segment.start, reach);
}

/// Whether two segments come within `reach` >= 0 of each other: at an end of one, or at the two
/// points between the ends where their lines are closest.
template <Scalar S, int N, Number R>
[[nodiscard]] constexpr bool within_reach(const Segment<S, N>& a, const Segment<S, N>& b,
                                          const R& reach) noexcept {
  if (are_apart(Bounds(a.start, a.end), Bounds(b.start, b.end), reach)) return false;
  if constexpr (N == 2) {
    return within_reach(a, b.start, reach) || within_reach(a, b.end, reach) ||
           within_reach(b, a.start, reach) || within_reach(b, a.end, reach) || segments_meet(a, b);
  } else {
    return by_width<29>([](const auto&... x) { return within_segments(x...); }, a.end - a.start,
                        b.end - b.start, b.start - a.start, reach);
  }
}

}  // namespace detent::detail
