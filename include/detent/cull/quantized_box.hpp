// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "detent/cull/grid.hpp"
#include "detent/math/orthonormal.hpp"
#include "detent/shape/bounding_box.hpp"
#include "detent/shape/plane.hpp"

// Broad-phase boxes, on the grid of cull/grid.hpp: if a query finds that two shapes overlap, their
// boxes overlap too.
//
// A box around the points of each shape is not enough: round shapes measure distances to an `Obb`
// in the frame of the box, whose axes are only nearly perpendicular. Let |dot(axis(i), axis(j))| be
// at most e = 2^-10 off 0, and off 1 for i = j. Then A, with the axes as rows, changes lengths by a
// factor within sqrt(1 +- 3 e). Its inverse is A^T (A A^T)^-1, where the last factor is 1 within 3
// e / (1 - 3 e) < 4 e = 2^-8 (in the sum of the absolute values of a row). So the slabs lie within
// the edges if each half extent is lengthened by 2^-8 of the greatest, and points within r of them
// in the frame are within r (1 + 2^-8). That is the margin of a `Reach`. Boxes with other axes
// count as unbounded.                                  (tests/scene/history.test.cpp, skewed boxes)

namespace detent::detail {

/// A box of the grid; empty when low > high.
template <Scalar S, int N>
struct QuantizedBox {
  using Coordinate = typename Grid<S>::Coordinate;
  std::array<Coordinate, static_cast<std::size_t>(N)> low;
  std::array<Coordinate, static_cast<std::size_t>(N)> high;

  constexpr QuantizedBox() noexcept = default;
  /// A box that ends where the scalar's range ends was clamped there, so it counts as unbounded.
  explicit constexpr QuantizedBox(const Aabb<S, N>& box) noexcept {
    const bool none = detent::is_empty(box);
    for (int i = 0; i < N; ++i) {
      const auto at = static_cast<std::size_t>(i);
      low[at] = none ? Grid<S>::beyond : Grid<S>::below(box.min[i]);
      high[at] = none ? -Grid<S>::beyond : Grid<S>::above(box.max[i]);
    }
  }
  /// The box around all points within `reach` of `core`, which must not be empty.
  constexpr QuantizedBox(const Aabb<S, N>& core, const Reach<S>& reach) noexcept {
    for (int i = 0; i < N; ++i) {
      const auto at = static_cast<std::size_t>(i);
      low[at] = Grid<S>::below(core.min[i], reach);
      high[at] = Grid<S>::above(core.max[i], reach);
    }
  }
  /// The box around all points within reach[i] of `center` on axis i.
  constexpr QuantizedBox(const Vec<S, N>& center,
                         const std::array<Reach<S>, static_cast<std::size_t>(N)>& reach) noexcept {
    for (int i = 0; i < N; ++i) {
      const auto at = static_cast<std::size_t>(i);
      low[at] = Grid<S>::below(center[i], reach[at]);
      high[at] = Grid<S>::above(center[i], reach[at]);
    }
  }
  [[nodiscard]] static constexpr QuantizedBox none() noexcept {
    return QuantizedBox(no_box<Aabb<S, N>>);
  }
  [[nodiscard]] static constexpr QuantizedBox everywhere() noexcept {
    QuantizedBox result;
    result.low.fill(-Grid<S>::beyond);
    result.high.fill(Grid<S>::beyond);
    return result;
  }

  [[nodiscard]] friend constexpr bool operator==(const QuantizedBox&,
                                                 const QuantizedBox&) noexcept = default;
  [[nodiscard]] constexpr bool is_empty() const noexcept { return low[0] > high[0]; }
};

template <Scalar S, int N>
[[nodiscard]] constexpr QuantizedBox<S, N> quantized_box(const Vec<S, N>& point) noexcept {
  return QuantizedBox(Aabb<S, N>{point, point});
}
template <class Shape>
[[nodiscard]] constexpr auto quantized_box(const Shape& shape) noexcept {
  return QuantizedBox(bounding_box(shape));
}
template <Round Shape>
[[nodiscard]] constexpr auto quantized_box(const Shape& shape) noexcept {
  const auto core = core_box(ShapeFields<Shape>::core(shape));
  using Box = decltype(QuantizedBox(core));
  return shape.radius < 0 ? Box::none()
                          : Box(core, Reach<decltype(shape.radius)>(shape.radius, shape.radius));
}
template <Scalar S, int N>
[[nodiscard]] constexpr QuantizedBox<S, N> quantized_box(const Plane<S, N>&) noexcept {
  return QuantizedBox<S, N>::everywhere();
}

template <Scalar S, int N>
[[nodiscard]] constexpr QuantizedBox<S, N> quantized_box(const Obb<S, N>& box) noexcept {
  if (is_empty(box)) return QuantizedBox<S, N>::none();
  if (!are_perpendicular<10>(box.rotation)) return QuantizedBox<S, N>::everywhere();
  S greatest = box.half_extents[0];
  for (int i = 1; i < N; ++i) greatest = (std::max)(greatest, box.half_extents[i]);
  std::array<Reach<S>, static_cast<std::size_t>(N)> extents, reach;
  for (int i = 0; i < N; ++i) {
    extents[static_cast<std::size_t>(i)] = Reach<S>(box.half_extents[i], greatest);
  }
  for (int j = 0; j < N; ++j) {
    const auto row = make_vec<N>([&](int i) { return box.rotation.axis(i)[j]; });
    reach[static_cast<std::size_t>(j)] = Reach<S>(extents, to_array(row));
  }
  return {box.center, reach};
}

}  // namespace detent::detail
