// SPDX-License-Identifier: MIT
#pragma once

#include "oracle/corners.hpp"

// A shape is all points within its radius of its core.
namespace detent::oracle {

/// The core of a round shape: a segment, which may be a point.
template <class Shape>
const Shape& core(const Shape& shape) {
  return shape;
}
template <int N>
Edge<N> core(const Ball<N>& ball) {
  return {ball.center, ball.center};
}
template <int N>
Edge<N> core(const Pill<N>& pill) {
  return pill.core;
}

template <class Shape>
Integer radius(const Shape& shape) {
  if constexpr (requires { shape.radius; }) {
    return shape.radius;
  } else {
    return 0;
  }
}

template <class Shape>
bool has_points(const Shape& shape) {
  if constexpr (requires { hull_of(shape); }) {
    return !hull_of(shape).over.empty();
  } else {
    return radius(shape) >= 0;
  }
}

/// The points of a hull in steps of 1 / `under` raw units.
template <int N>
std::vector<Vector<N>> points_over(const Hull<N>& hull, const Integer& under) {
  auto points = hull.over;
  for (auto& point : points) {
    for (auto& component : point) component *= under / hull.under;
  }
  return points;
}

/// The box and a thin shape in the frame of the box, as slabs: both in steps of 1 / (one under) raw
/// units.
template <int N>
struct InFrame {
  Hull<N> box, thin;
};
template <int N>
InFrame<N> in_frame(const TurnedBox<N>& box, const Hull<N>& thin) {
  Hull<N> result{{}, box.one * thin.under};
  for (const auto& point : thin.over) {
    Vector<N> from_center = point, place;
    for (std::size_t i = 0; i < place.size(); ++i) from_center[i] -= box.center[i] * thin.under;
    for (std::size_t i = 0; i < place.size(); ++i) place[i] = dot(box.axes[i], from_center);
    result.over.push_back(place);
  }
  std::array<Vector<N>, N> edges;
  for (std::size_t i = 0; i < edges.size(); ++i) edges[i][i] = box.half[i];
  return {corners<N>(Vector<N>{}, edges, 1), result};
}

}  // namespace detent::oracle
