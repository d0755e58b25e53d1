// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "detent/shape/bounding_box.hpp"
#include "detent/shape/bounding_sphere.hpp"
#include "detent/shape/moved.hpp"

// The shapes that characters have: capsules, spheres and axis-aligned boxes.

namespace detent::detail {

/// The shape grown by `by` on all sides, or shrunk by a negative number: a superset of all points
/// within `by` of it.
template <Round Shape, Scalar S>
[[nodiscard]] constexpr Shape grown(Shape shape, const S& by) noexcept {
  shape.radius = nearest_to<S>(shape.radius + by);
  return shape;
}
template <Scalar S, int N>
[[nodiscard]] constexpr Aabb<S, N> grown(const Aabb<S, N>& box, const S& by) noexcept {
  return {make_vec<N>([&](int i) { return nearest_to<S>(box.min[i] - by); }),
          make_vec<N>([&](int i) { return nearest_to<S>(box.max[i] + by); })};
}

/// How far the shape can shrink until nothing is left, rounded down; negative for an empty shape.
template <Round Shape>
[[nodiscard]] constexpr auto thickness(const Shape& shape) noexcept {
  return shape.radius;
}
template <Scalar S, int N>
[[nodiscard]] constexpr S thickness(const Aabb<S, N>& box) noexcept {
  auto least = box.max.x - box.min.x;
  for (int i = 1; i < N; ++i) least = (std::min)(least, box.max[i] - box.min[i]);
  return floor_to<S>(half(least));
}

/// The middle of the box around a round shape, as of an `Aabb`.
template <Round Shape>
[[nodiscard]] constexpr auto middle(const Shape& shape) noexcept {
  return middle(core_box(ShapeFields<Shape>::core(shape)));
}

/// The least and the greatest coordinate on axis `i`, exactly.
template <Round Shape>
[[nodiscard]] constexpr auto least_on(const Shape& shape, int i) noexcept {
  return core_box(ShapeFields<Shape>::core(shape)).min[i] - shape.radius;
}
template <Round Shape>
[[nodiscard]] constexpr auto greatest_on(const Shape& shape, int i) noexcept {
  return core_box(ShapeFields<Shape>::core(shape)).max[i] + shape.radius;
}
template <Scalar S, int N>
[[nodiscard]] constexpr S least_on(const Aabb<S, N>& box, int i) noexcept {
  return box.min[i];
}
template <Scalar S, int N>
[[nodiscard]] constexpr S greatest_on(const Aabb<S, N>& box, int i) noexcept {
  return box.max[i];
}

/// The coordinate of the lowest point along `up`.
template <Scalar S, int N>
[[nodiscard]] constexpr auto lowest_along(const Vec<S, N>& point,
                                          const Direction<S, N>& up) noexcept {
  return dot(point, up);
}
template <Scalar S, int N>
[[nodiscard]] constexpr auto lowest_along(const Segment<S, N>& axis,
                                          const Direction<S, N>& up) noexcept {
  return (std::min)(dot(axis.start, up), dot(axis.end, up));
}
template <Round Shape, Scalar S, int N>
[[nodiscard]] constexpr auto lowest_along(const Shape& shape, const Direction<S, N>& up) noexcept {
  return lowest_along(ShapeFields<Shape>::core(shape), up) - shape.radius;
}
template <Scalar S, int N>
[[nodiscard]] constexpr auto lowest_along(const Aabb<S, N>& box,
                                          const Direction<S, N>& up) noexcept {
  return dot(make_vec<N>([&](int i) { return up[i] < 0 ? box.max[i] : box.min[i]; }), up);
}

/// Whether the shape, with a margin, stays in the range of the scalar when it moves by `by`, or at
/// least comes no closer to the end of the range. Then `translated` moves it exactly.
template <class Shape, Scalar S, int N>
[[nodiscard]] constexpr bool stays_in_range(const Shape& shape, const Vec<S, N>& by,
                                            const S& margin) noexcept {
  for (int i = 0; i < N; ++i) {
    if (by[i] < 0 && least_on(shape, i) - margin + by[i] < detent::lowest<S>) return false;
    if (by[i] > 0 && greatest_on(shape, i) + margin + by[i] > largest<S>) return false;
  }
  return true;
}

}  // namespace detent::detail
