// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "detent/cull/grid.hpp"
#include "detent/math/orthonormal.hpp"
#include "detent/shape/bounding_box.hpp"
#include "detent/shape/plane.hpp"

// Broad-phase boxes, on the grid of cull/grid.hpp: if a query finds that two shapes overlap,
// their boxes overlap too.
//
// A box around the points of each shape is not enough: round shapes measure distances to an `Obb`
// in the frame of the box, whose axes are only nearly perpendicular. Let |dot(axis(i), axis(j))| be
// at most e = 2^-10 off 0, and off 1 for i = j. Then A, with the axes as rows, changes lengths by a
// factor within sqrt(1 +- 3 e). Its inverse is A^T (A A^T)^-1, where the last factor is 1 within
// 3 e / (1 - 3 e) < 4 e = 2^-8 (in the sum of the absolute values of a row). So the slabs lie
// within the edges if each half extent is lengthened by 2^-8 of the greatest, and points within r
// of them in the frame are within r (1 + 2^-8).
// Boxes with other axes count as everywhere.         (tests/scene/history.test.cpp, skewed boxes)
// Margins are added on the grid, where the scalar's range does not cut them off.
//                                                             (tests/scene/bounds.test.cpp)

namespace detent::detail {

/// A box of the grid; empty when low > high.
template <Scalar S, int N>
struct QuantizedBox {
  using Coordinate = typename Grid<S>::Coordinate;
  std::array<Coordinate, static_cast<std::size_t>(N)> low;
  std::array<Coordinate, static_cast<std::size_t>(N)> high;

  [[nodiscard]] friend constexpr bool operator==(const QuantizedBox&,
                                                 const QuantizedBox&) noexcept = default;
  [[nodiscard]] constexpr bool is_empty() const noexcept { return low[0] > high[0]; }
};

template <Scalar S, int N>
[[nodiscard]] constexpr QuantizedBox<S, N> quantized_box_of(const Aabb<S, N>& box) noexcept {
  QuantizedBox<S, N> result;
  const bool none = is_empty(box);
  for (int i = 0; i < N; ++i) {
    const auto at = static_cast<std::size_t>(i);
    result.low[at] = none ? Grid<S>::beyond : Grid<S>::below(box.min[i]);
    result.high[at] = none ? -Grid<S>::beyond : Grid<S>::above(box.max[i]);
  }
  return result;
}

template <Scalar S, int N>
[[nodiscard]] constexpr QuantizedBox<S, N> everywhere() noexcept {
  QuantizedBox<S, N> result;
  result.low.fill(-Grid<S>::beyond);
  result.high.fill(Grid<S>::beyond);
  return result;
}

/// The box around all points within `reach` of `box`, which must not be empty.
template <Scalar S, int N>
[[nodiscard]] constexpr QuantizedBox<S, N> quantized_box_around(
    const Aabb<S, N>& box, const typename Grid<S>::Length& reach) noexcept {
  QuantizedBox<S, N> result;
  for (int i = 0; i < N; ++i) {
    const auto at = static_cast<std::size_t>(i);
    result.low[at] = Grid<S>::below(box.min[i], reach);
    result.high[at] = Grid<S>::above(box.max[i], reach);
  }
  return result;
}

template <Scalar S, int N>
[[nodiscard]] constexpr QuantizedBox<S, N> quantized_box(const Vec<S, N>& point) noexcept {
  return quantized_box_of(Aabb<S, N>{point, point});
}
template <class Shape>
[[nodiscard]] constexpr auto quantized_box(const Shape& shape) noexcept {
  return quantized_box_of(bounding_box(shape));
}
template <Scalar S, int N>
[[nodiscard]] constexpr QuantizedBox<S, N> quantized_box(const Capsule<S, N>& capsule) noexcept {
  if (capsule.radius < 0) return quantized_box_of(no_box<Aabb<S, N>>);
  return quantized_box_around(bounding_box(Segment{capsule.a, capsule.b}),
                              Grid<S>::padded(capsule.radius, capsule.radius));
}
template <Scalar S, int N>
[[nodiscard]] constexpr QuantizedBox<S, N> quantized_box(const Sphere<S, N>& sphere) noexcept {
  return quantized_box(Capsule<S, N>{sphere.center, sphere.center, sphere.radius});
}
template <Scalar S, int N>
[[nodiscard]] constexpr QuantizedBox<S, N> quantized_box(const Plane<S, N>&) noexcept {
  return everywhere<S, N>();
}

template <Scalar S, int N>
[[nodiscard]] constexpr QuantizedBox<S, N> quantized_box(const Obb<S, N>& box) noexcept {
  if (is_empty(box)) return quantized_box_of(no_box<Aabb<S, N>>);
  if (!are_perpendicular<10>(box.rotation)) return everywhere<S, N>();
  S greatest = box.half_extents[0];
  for (int i = 1; i < N; ++i) greatest = (std::max)(greatest, box.half_extents[i]);
  std::array<typename Grid<S>::Length, static_cast<std::size_t>(N)> extents;
  for (int i = 0; i < N; ++i) {
    extents[static_cast<std::size_t>(i)] = Grid<S>::padded(box.half_extents[i], greatest);
  }
  QuantizedBox<S, N> result;
  for (int j = 0; j < N; ++j) {
    const auto row = make_vec<N>([&](int i) { return box.rotation.axis(i)[j]; });
    const auto reach = Grid<S>::reach(extents, to_array(row));
    const auto at = static_cast<std::size_t>(j);
    result.low[at] = Grid<S>::below(box.center[j], reach);
    result.high[at] = Grid<S>::above(box.center[j], reach);
  }
  return result;
}

}  // namespace detent::detail
