// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/closest_point/triangle.hpp"
#include "detent/query/kernel/point_hull.hpp"

namespace detent {

/// The point of `hull` closest to `point`; `point` itself if inside.
///
/// It is the closest point on the corner, edge or face where GJK ends.
///
/// units:  world units
/// domain: every input; an empty hull gives `point`
/// exact:  each coordinate is the exact one rounded to nearest, ties to even
///         (tests/oracle/point_hull.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<S, N> closest_point(const ConvexHull<S, N>& hull,
                                                const Vec<S, N>& point) noexcept {
  if (is_empty(hull)) return point;
  return detail::with_gjk(
      detail::HullBody(hull), detail::HullBody(detail::hull_of(point)), [&](auto search) {
        if (search.touches()) return point;
        const auto& feature = search.closest_feature();
        // Corners of the hull; the last one repeats.
        const auto corner = [&](int i) {
          return nearest_to<S>(point + feature[(std::min)(i, feature.count - 1)]);
        };
        if constexpr (N == 2) {
          return closest_point(Segment{corner(0), corner(1)}, point);
        } else {
          return closest_point(Triangle{corner(0), corner(1), corner(2)}, point);
        }
      });
}

}  // namespace detent
