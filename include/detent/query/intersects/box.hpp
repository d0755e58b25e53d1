// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "detent/math/vec.hpp"

namespace detent::detail {

/// Whether the segment from `p` to `q` has a point in the box {x : |x[i]| <= half_extents[i]},
/// whose half extents are not negative.
///
/// If they are apart, an axis of the box or the cross product of one with the segment tells so: the
/// segment's line passes the origin at p x q, and the box reaches |d[j]| h[k] + |d[k]| h[j] across
/// its direction d. The caller knows that either fits `ProductBits`.
///
/// source: separating axes, Ericson, Real-Time Collision Detection, 5.3.3
template <int ProductBits, Number T, int N>
[[nodiscard]] constexpr bool segment_meets_box(const Vec<T, N>& p, const Vec<T, N>& q,
                                               const Vec<T, N>& half_extents) noexcept {
  const auto& h = half_extents;
  for (int i = 0; i < N; ++i) {
    if (std::min(p[i], q[i]) > h[i]) return false;
    if (std::max(p[i], q[i]) < narrow_negative(h[i])) return false;
  }
  const auto length = make_vec<N>(
      [&](int i) { return narrow<bits_of<T>>(abs(narrow_difference<bits_of<T>>(q[i], p[i]))); });
  for (int j = 0, last = N == 2 ? 1 : 3; j < last; ++j) {
    const int k = (j + 1) % N;
    const auto passes = narrow_cross<ProductBits>(Vec{p[j], p[k]}, Vec{q[j], q[k]});
    const auto reaches = narrow_sum<ProductBits>(narrow_product<ProductBits>(length[j], h[k]),
                                                 narrow_product<ProductBits>(length[k], h[j]));
    if (abs(passes) > reaches) return false;
  }
  return true;
}

}  // namespace detent::detail
