// SPDX-License-Identifier: MIT
#pragma once

#include "query/hulls.hpp"
#include "query/overlaps/helpers.hpp"

namespace detent::test {

/// Whether a shape overlaps a hull; checks both argument orders, any order of the points, and
/// permuted axes.
template <class Shape, Scalar S, int N, std::size_t Count>
bool meets(const Shape& shape, const Points<S, N, Count>& points) {
  const auto turn = [](const auto& v) { return turned(v); };
  auto turned_points = points;
  for (auto& point : turned_points) point = turned(point);
  return in_every_order(points, [&](const auto& hull) {
    const ConvexHull<S, N> turned_hull{turned_points};
    if constexpr (std::is_same_v<Shape, Segment<S, N>>) {
      CHECK(intersects(changed(shape, turn), turned_hull) == intersects(shape, hull));
      return intersects(shape, hull);
    } else {
      CHECK(overlaps(hull, shape) == overlaps(shape, hull));
      CHECK(overlaps(changed(shape, turn), turned_hull) == overlaps(shape, hull));
      return overlaps(shape, hull);
    }
  });
}
template <Scalar S, int N, std::size_t A, std::size_t B>
bool meets(const Points<S, N, A>& a, const Points<S, N, B>& b) {
  return in_every_order(a, [&](const ConvexHull<S, N>& first) {
    return in_every_order(b, [&](const ConvexHull<S, N>& second) {
      CHECK(overlaps(second, first) == overlaps(first, second));
      return overlaps(first, second);
    });
  });
}

}  // namespace detent::test
