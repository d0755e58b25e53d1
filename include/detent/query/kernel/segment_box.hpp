// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "detent/math/vec.hpp"
#include "detent/number/filter/filtered.hpp"

namespace detent::detail {

/// Filter in 64 bits: whether the line through `p` and `q`, `length` apart along each axis, meets
/// the box with these half extents. No axis of the box may separate box and segment
/// (docs/filters.md, lemma 8).
template <Number T, int N>
[[nodiscard]] constexpr Filtered decide_line_meets_box(const Vec<T, N>& p, const Vec<T, N>& q,
                                                       const Vec<T, N>& length,
                                                       const Vec<T, N>& half_extents) noexcept {
  constexpr int bits = 62;
  using Slack = Fixed<63, 2 * T::frac>;
  Slack least = (Slack::max)();
  constexpr auto steps = T::from_raw(4);
  auto size = narrow<36>(steps);
  for (int i = 0; i < N; ++i) size = narrow_sum<36>(size, length[i] + half_extents[i]);
  for (int j = 0, last = N == 2 ? 1 : 3; j < last; ++j) {
    const int k = (j + 1) % N;
    const auto passes = narrow_cross<bits>(Vec{p[j], p[k]}, Vec{q[j], q[k]});
    const auto reaches =
        narrow_dot<bits>(Vec{length[j], length[k]}, Vec{half_extents[k], half_extents[j]});
    const Slack slack = narrow_difference<63>(reaches, abs(passes));
    least = slack < least ? slack : least;
  }
  return decide(Approximate{least, Slack(narrow_product<bits>(size, steps))});
}

/// Whether the segment from `p` to `q` has a point in the box {x : |x[i]| <= half_extents[i]},
/// whose half extents are not negative.
///
/// If they are apart, an axis of the box or its cross product with the segment separates them: the
/// segment's line has the moment p x q about the origin, and the box reaches |d[j]| h[k] + |d[k]|
/// h[j] across its direction d.
///
/// source: separating axes, Ericson, Real-Time Collision Detection, 5.3.3
template <Number T, int N>
[[nodiscard]] constexpr bool segment_meets_box(const Vec<T, N>& p, const Vec<T, N>& q,
                                               const Vec<T, N>& half_extents) noexcept {
  const auto& h = half_extents;
  for (int i = 0; i < N; ++i) {
    const auto low = narrow_negative(h[i]);
    if constexpr (is_fixed<T>) {  // sums: branches on each end would be unpredictable
      if (int{p[i] > h[i]} + int{q[i] > h[i]} == 2) return false;
      if (int{p[i] < low} + int{q[i] < low} == 2) return false;
    } else {
      if ((std::min)(p[i], q[i]) > h[i]) return false;
      if ((std::max)(p[i], q[i]) < low) return false;
    }
  }
  // Each is the sum of two products of a length, at most 2^(B + 1), and a coordinate. Sums with
  // directions fit 127 bits: Cauchy-Schwarz keeps them below 2^125.7 for 32-bit scalars.
  constexpr int product_bits = (std::min)(2 * bits_of<T> + 2, 127);
  constexpr int length_bits = (std::max)(bits_of<T>, 32);
  const auto length =
      make_vec<N>([&](int i) { return narrow_abs(narrow_difference<length_bits>(q[i], p[i])); });
  const auto exact = [&] {
    for (int j = 0, last = N == 2 ? 1 : 3; j < last; ++j) {
      const int k = (j + 1) % N;
      const auto passes = narrow_cross<product_bits>(Vec{p[j], p[k]}, Vec{q[j], q[k]});
      const auto reaches = narrow_sum<product_bits>(narrow_product<product_bits>(length[j], h[k]),
                                                    narrow_product<product_bits>(length[k], h[j]));
      if (abs(passes) > reaches) return false;
    }
    return true;
  };
  if constexpr (has_filters && 32 < bits_of<T>) {
    constexpr int kept = 30, dropped = length_bits - kept;
    const auto cut = [](const auto& v) {
      return make_vec<N>([&](int i) { return scale_down<kept>(v[i], dropped); });
    };
    return or_exact(decide_line_meets_box(cut(p), cut(q), cut(length), cut(h)), exact);
  } else {
    return exact();
  }
}

}  // namespace detent::detail
