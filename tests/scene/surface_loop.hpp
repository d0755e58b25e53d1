// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include "detent/query/contains.hpp"
#include "detent/query/distance.hpp"
#include "detent/query/intersects.hpp"
#include "detent/query/overlaps.hpp"
#include "detent/query/raycast.hpp"

namespace detent::test {

/// A surface as a list of triangles, whose queries test each of them.
template <Scalar S>
struct TriangleLoop {
  std::vector<Triangle<S, 3>> triangles;

  template <class Test>
  [[nodiscard]] bool any(const Test& test) const {
    return std::any_of(triangles.begin(), triangles.end(), test);
  }
};

template <Scalar S>
std::optional<S> raycast(const Ray<S, 3>& ray, const TriangleLoop<S>& loop) {
  std::optional<S> best;
  for (const auto& triangle : loop.triangles) {
    const auto distance = raycast(ray, triangle);
    if (distance && (!best || *distance < *best)) best = distance;
  }
  return best;
}
template <Scalar S>
S distance(const TriangleLoop<S>& loop, const Vec<S, 3>& point) {
  S best = largest<S>;
  for (const auto& triangle : loop.triangles) best = std::min(best, distance(triangle, point));
  return best;
}
template <Scalar S>
bool contains(const TriangleLoop<S>& loop, const Vec<S, 3>& point) {
  return loop.any([&](const auto& triangle) { return contains(triangle, point); });
}
template <Scalar S>
bool intersects(const Segment<S, 3>& segment, const TriangleLoop<S>& loop) {
  return loop.any([&](const auto& triangle) { return intersects(segment, triangle); });
}
template <Scalar S, class Shape>
bool overlaps(const TriangleLoop<S>& loop, const Shape& shape) {
  return loop.any([&](const auto& triangle) { return overlaps(shape, triangle); });
}
template <Scalar S, class Shape>
bool overlaps(const Shape& shape, const TriangleLoop<S>& loop) {
  return overlaps(loop, shape);
}
template <Scalar S>
bool overlaps(const TriangleLoop<S>& a, const TriangleLoop<S>& b) {
  return a.any([&](const auto& triangle) { return overlaps(b, triangle); });
}

}  // namespace detent::test
