// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "detent/math/vec.hpp"

// The pivot rule of the linear program in stab.hpp: which point enters the basis, and which column
// leaves.
//
// The point farthest in front of the plane of the basis enters. The column whose weight falls to 0
// first leaves, so the line stabs the new basis too. A step that moves nothing, because that weight
// already was 0, is degenerate: after it, steps take the first point and the first column that
// qualify, until one moves. So no basis repeats, and the search ends.
//
// source: Dantzig's simplex method; Bland, New Finite Pivoting Rules for the Simplex Method (1977)

namespace detent::detail {

using PointIndex = std::ptrdiff_t;

/// The index of a column that is a direction.
inline constexpr PointIndex no_point = -1;

/// The point farthest against v from `from`, or with `first` the first point against it; `no_point`
/// if there is none.
template <Number V, Number S, int N>
[[nodiscard]] constexpr PointIndex entering_point(std::span<const Vec<S, N>> points,
                                                  const Vec<V, N>& v, const Vec<S, N>& from,
                                                  bool first) noexcept {
  PointIndex best = no_point;
  auto depth = dot(v, from - from);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto here = dot(v, points[i] - from);
    if (here < depth) {
      best = static_cast<PointIndex>(i);
      depth = here;
      if (first) return best;
    }
  }
  return best;
}

/// A basis and an entering point w.
///
/// The line has the direction d and passes through 0. The weights of columns a, b, c are the
/// volumes d . (b x c), d . (c x a), d . (a x b), and the sides of w are d . (w x a), d . (w x b),
/// d . (w x c). In 2D the weights of a and b are b x d and d x a, and the sides of w are w x d and
/// d x w.
template <Number Weight, int N>
struct Pivot {
  std::array<Weight, static_cast<std::size_t>(N)> weights;
  std::array<Weight, static_cast<std::size_t>(N)> sides;
  std::array<PointIndex, static_cast<std::size_t>(N)> indices;

  /// The leaving column, in case of a tie the one with the least index; N if no weight falls. The
  /// falls have the sum of the weights, so that only happens by rounding.
  [[nodiscard]] constexpr int leaving() const noexcept {
    int result = N;
    for (int i = 0; i < N; ++i) {
      if (fall(i) > 0 && (result == N || is_before(i, result))) result = i;
    }
    return result;
  }

 private:
  /// How fast weight i falls as that of w grows and the total stays constant. If another sum stays
  /// constant, such as that of the points, weights fall faster or slower in proportion to
  /// themselves, and reach 0 in the same order.
  [[nodiscard]] constexpr auto fall(int i) const noexcept {
    if constexpr (N == 2) {
      return weights[at(i)] - sides[at(i)];
    } else {
      return weights[at(i)] + sides[at((i + 1) % 3)] - sides[at((i + 2) % 3)];
    }
  }

  /// Whether weight i reaches 0 before weight j. The sign of the volume of the third column and w
  /// decides: it is the side on which the line passes their edge.
  [[nodiscard]] constexpr bool is_before(int i, int j) const noexcept {
    const auto& third = sides[at(N == 2 ? i : 3 - i - j)];
    if (third == 0) return indices[at(i)] < indices[at(j)];
    return (N == 2 || j == (i + 1) % 3) == (third < 0);
  }

  [[nodiscard]] static constexpr std::size_t at(int i) noexcept {
    return static_cast<std::size_t>(i);
  }
};

}  // namespace detent::detail
