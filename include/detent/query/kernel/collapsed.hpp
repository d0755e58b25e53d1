// SPDX-License-Identifier: MIT
#pragma once

#include "detent/shape/segment.hpp"
#include "detent/shape/triangle.hpp"

namespace detent::detail {

/// The segment that a collapsed triangle is.
template <Scalar S, int N>
[[nodiscard]] constexpr Segment<S, N> collapsed(const Triangle<S, N>& triangle) noexcept {
  // On one line the lexicographic order of coordinates is the order along the line.
  const auto before = [](const Vec<S, N>& p, const Vec<S, N>& q) {
    for (int i = 0; i < N; ++i) {
      if (p[i] != q[i]) return p[i] < q[i];
    }
    return false;
  };
  Segment<S, N> ends{triangle.a, triangle.a};
  for (const auto& corner : {triangle.b, triangle.c}) {
    if (before(corner, ends.start)) ends.start = corner;
    if (before(ends.end, corner)) ends.end = corner;
  }
  return ends;
}

}  // namespace detent::detail
