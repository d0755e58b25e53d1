// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "c/convert.hpp"

// Kinds of shape as fewer types, for queries that take minutes to compile for every pair: triangles and
// AABBs as the hull of their corners, spheres and segments as capsules, with equal ends or the radius 0.
// Only queries whose answers depend on the points alone use this, and on whether a shape is round or
// thin next to an OBB (tests/c/pairs.test.cpp compares all kinds).
namespace detent::c {

template <int N>
[[nodiscard]] std::array<Vec<S, N>, std::size_t{1} << N> corners_of(const Aabb<S, N>& box) {
  std::array<Vec<S, N>, std::size_t{1} << N> corners;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    corners[k] = make_vec<N>([&](int i) { return (k >> i & 1) != 0 ? box.max[i] : box.min[i]; });
  }
  return corners;
}

/// Calls f(points) with a capsule, OBB, plane or hull that has the points of the shape.
template <int N, class F>
detent_status with_points(const typename Types<N>::Shape& shape, const F& f) {
  return with_shape<N>(shape, [&](const auto& read) -> detent_status {
    using Shape = std::remove_cvref_t<decltype(read)>;
    const auto hull_of = [&](const auto& corners) {
      return f(ConvexHull<S, N>{std::span<const Vec<S, N>>(corners)});
    };
    if constexpr (std::is_same_v<Shape, Segment<S, N>>) {
      return f(Capsule<S, N>{read.start, read.end, S(0)});
    } else if constexpr (std::is_same_v<Shape, Triangle<S, N>>) {
      return hull_of(std::array{read.a, read.b, read.c});
    } else if constexpr (std::is_same_v<Shape, Aabb<S, N>>) {
      return is_empty(read) ? f(ConvexHull<S, N>()) : hull_of(corners_of(read));
    } else if constexpr (std::is_same_v<Shape, Sphere<S, N>>) {
      return f(Capsule<S, N>{read.center, read.center, read.radius});
    } else {
      return f(read);
    }
  });
}

}  // namespace detent::c
