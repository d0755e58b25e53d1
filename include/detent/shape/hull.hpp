// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "detent/math/vec.hpp"

namespace detent {

/// The smallest convex set that contains `points`: a view of points that the caller owns.
///
/// The points may be in any order, repeat, or lie inside the hull. Coplanar, collinear or
/// coincident points make it the polygon, segment or point that they span; without points it is
/// empty.
template <Scalar S, int N>
struct ConvexHull {
  std::span<const Vec<S, N>> points;

  /// Whether two hulls have the same points in the same order.
  [[nodiscard]] friend constexpr bool operator==(const ConvexHull& a,
                                                 const ConvexHull& b) noexcept {
    return std::equal(a.points.begin(), a.points.end(), b.points.begin(), b.points.end());
  }
};

/// Appends to a digest: how many points as 64 bits, then the points in order.
template <class D, Scalar S, int N>
constexpr void append(D& digest, const ConvexHull<S, N>& hull) noexcept {
  digest.add(static_cast<std::uint64_t>(hull.points.size()));
  for (const auto& point : hull.points) digest.add(point);
}

template <Scalar S, int N, std::size_t Count>
ConvexHull(const std::array<Vec<S, N>, Count>&) -> ConvexHull<S, N>;
template <Scalar S, int N, std::size_t Count>
ConvexHull(const Vec<S, N> (&)[Count]) -> ConvexHull<S, N>;
template <Scalar S, int N, std::size_t Extent>
ConvexHull(std::span<Vec<S, N>, Extent>) -> ConvexHull<S, N>;
template <Scalar S, int N, std::size_t Extent>
ConvexHull(std::span<const Vec<S, N>, Extent>) -> ConvexHull<S, N>;

/// Whether the hull holds no point: it has no `points`.
template <Scalar S, int N>
[[nodiscard]] constexpr bool is_empty(const ConvexHull<S, N>& hull) noexcept {
  return hull.points.empty();
}

}  // namespace detent
