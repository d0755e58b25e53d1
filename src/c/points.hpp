// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "c/convert.hpp"

// Maps kinds of shape to fewer types, for queries that take minutes to compile for every pair:
// triangles and AABBs become the hull of their corners, spheres and segments capsules, with equal
// ends or the radius 0. Only for queries whose results depend only on the points, and on whether a
// shape is round or thin next to an OBB (tests/c/pairs.test.cpp compares all kinds).
namespace detent::c {

template <int N>
[[nodiscard]] std::array<Vec<S, N>, std::size_t{1} << N> corners_of(const Aabb<S, N>& box) {
  std::array<Vec<S, N>, std::size_t{1} << N> corners;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    corners[k] = make_vec<N>([&](int i) { return (k >> i & 1) != 0 ? box.max[i] : box.min[i]; });
  }
  return corners;
}

/// Returns f(points) for a capsule, OBB, plane or hull with the points of the shape.
template <class Shape, class F>
auto as_points(const Shape& shape, const F& f) {
  return f(shape);
}
template <int N, class F>
auto as_points(const Segment<S, N>& segment, const F& f) {
  return f(Capsule<S, N>{segment.start, segment.end, S(0)});
}
template <int N, class F>
auto as_points(const Sphere<S, N>& sphere, const F& f) {
  return f(Capsule<S, N>{sphere.center, sphere.center, sphere.radius});
}
template <int N, class F>
auto as_points(const Triangle<S, N>& triangle, const F& f) {
  const std::array corners{triangle.a, triangle.b, triangle.c};
  return f(ConvexHull<S, N>{std::span<const Vec<S, N>>(corners)});
}
template <int N, class F>
auto as_points(const Aabb<S, N>& box, const F& f) {
  if (is_empty(box)) return f(ConvexHull<S, N>());
  const auto corners = corners_of(box);
  return f(ConvexHull<S, N>{std::span<const Vec<S, N>>(corners)});
}

/// The same for a shape of C.
template <int N, class F>
detent_status with_points(const typename Types<N>::Shape& shape, const F& f) {
  return with_shape<N>(shape,
                       [&](const auto& read) -> detent_status { return as_points(read, f); });
}

}  // namespace detent::c
