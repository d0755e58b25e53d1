// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "detent/shape/hull.hpp"
#include "query/raycast/helpers.hpp"

namespace detent::test {

template <Scalar S, int N, std::size_t Count>
using Points = std::array<Vec<S, N>, Count>;

/// The corners of {x : |x| + |y| (+ |z|) <= 4}, a diamond or an octahedron.
template <Scalar S, int N>
constexpr auto diamond() {
  Points<S, N, std::size_t{2 * N}> points;
  for (int i = 0; i < N; ++i) {
    points[static_cast<std::size_t>(2 * i)][i] = num<S>(4);
    points[static_cast<std::size_t>(2 * i + 1)][i] = num<S>(-4);
  }
  return points;
}

/// A square at z = 0 and its center, from -4 to 4 on the other axes; in 2D a segment at y = 0.
template <Scalar S, int N>
constexpr auto flat() {
  if constexpr (N == 2) {
    return Points<S, 2, 3>{at<S, 2>(-4), at<S, 2>(0), at<S, 2>(4)};
  } else {
    return Points<S, 3, 5>{at<S, 3>(-4, -4), at<S, 3>(4, 4), at<S, 3>(0), at<S, 3>(-4, 4),
                           at<S, 3>(4, -4)};
  }
}

/// Returns f(hull) for the points, and checks that reordering or duplicating them changes nothing.
template <Scalar S, int N, std::size_t Count, class F>
auto in_every_order(const Points<S, N, Count>& points, const F& f) {
  const auto answer = f(ConvexHull<S, N>{points});
  auto other = points;
  std::reverse(other.begin(), other.end());
  CHECK(f(ConvexHull<S, N>{other}) == answer);
  Points<S, N, 2 * Count> twice;
  for (std::size_t i = 0; i < 2 * Count; ++i) twice[i] = points[(i + 1) % Count];
  CHECK(f(ConvexHull<S, N>{twice}) == answer);
  return answer;
}

}  // namespace detent::test
