// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "detent/shape/aabb.hpp"
#include "detent/shape/capsule.hpp"
#include "detent/shape/compound.hpp"
#include "detent/shape/hull.hpp"
#include "detent/shape/obb.hpp"
#include "detent/shape/segment.hpp"
#include "detent/shape/sphere.hpp"
#include "detent/shape/triangle.hpp"

// The smallest box of the grid around points or a shape:
//   bounding_box(shape) -> Aabb<S, N>
//
// The box is clamped to the range of the scalar, beyond which no point can lie. An empty shape has
// an empty box.

namespace detent {

namespace detail {

/// The empty box, the identity of unions.
template <class Box>
inline constexpr Box no_box;
template <Scalar S, int N>
inline constexpr Aabb<S, N> no_box<Aabb<S, N>> = {make_vec<N>([](int) { return largest<S>; }),
                                                  make_vec<N>([](int) { return lowest<S>; })};

}  // namespace detail

/// The smallest box around points, empty if there are none.
///
/// exact: always                                           (tests/shape/bounding.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr Aabb<S, N> bounding_box(std::span<const Vec<S, N>> points) noexcept {
  auto box = detail::no_box<Aabb<S, N>>;
  for (const auto& point : points) {
    for (int i = 0; i < N; ++i) {
      box.min[i] = (std::min)(box.min[i], point[i]);
      box.max[i] = (std::max)(box.max[i], point[i]);
    }
  }
  return box;
}

/// The smallest box around two boxes.
template <Scalar S, int N>
[[nodiscard]] constexpr Aabb<S, N> bounding_box(const Aabb<S, N>& a, const Aabb<S, N>& b) noexcept {
  if (is_empty(a)) return b;
  if (is_empty(b)) return a;
  return {make_vec<N>([&](int i) { return (std::min)(a.min[i], b.min[i]); }),
          make_vec<N>([&](int i) { return (std::max)(a.max[i], b.max[i]); })};
}

template <Scalar S, int N>
[[nodiscard]] constexpr Aabb<S, N> bounding_box(const Aabb<S, N>& box) noexcept {
  return is_empty(box) ? detail::no_box<Aabb<S, N>> : box;
}

template <Scalar S, int N>
[[nodiscard]] constexpr Aabb<S, N> bounding_box(const ConvexHull<S, N>& hull) noexcept {
  return bounding_box(hull.points);
}

template <Scalar S, int N>
[[nodiscard]] constexpr Aabb<S, N> bounding_box(const Segment<S, N>& segment) noexcept {
  return bounding_box<S, N>(std::array{segment.start, segment.end});
}

template <Scalar S, int N>
[[nodiscard]] constexpr Aabb<S, N> bounding_box(const Triangle<S, N>& triangle) noexcept {
  return bounding_box<S, N>(std::array{triangle.a, triangle.b, triangle.c});
}

namespace detail {

/// The box around the core of a round shape.
template <Scalar S, int N>
[[nodiscard]] constexpr Aabb<S, N> core_box(const Vec<S, N>& point) noexcept {
  return {point, point};
}
template <Scalar S, int N>
[[nodiscard]] constexpr Aabb<S, N> core_box(const Segment<S, N>& segment) noexcept {
  return bounding_box(segment);
}

template <Scalar S, int N>
[[nodiscard]] constexpr Aabb<S, N> grown_box(const Aabb<S, N>& box, const S& radius) noexcept {
  if (radius < 0) return no_box<Aabb<S, N>>;
  return {make_vec<N>([&](int i) { return floor_to<S>(box.min[i] - radius); }),
          make_vec<N>([&](int i) { return ceil_to<S>(box.max[i] + radius); })};
}

}  // namespace detail

/// The box around the core of a round shape, grown by its radius and rounded outward.
template <detail::Round Shape>
[[nodiscard]] constexpr auto bounding_box(const Shape& shape) noexcept {
  return detail::grown_box(detail::core_box(detail::ShapeFields<Shape>::core(shape)), shape.radius);
}

/// The smallest box of the grid around the edges of an `Obb`: the points
/// center + sum s_i * half_extents[i] * axis(i) with |s_i| <= 1, its axes exactly as stored.
///
/// exact: rounded outward                                  (tests/shape/bounding.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr Aabb<S, N> bounding_box(const Obb<S, N>& box) noexcept {
  if (is_empty(box)) return detail::no_box<Aabb<S, N>>;
  const auto reach = make_vec<N>([&](int j) {
    return dot(box.half_extents, make_vec<N>([&](int i) { return abs(box.rotation.axis(i)[j]); }));
  });
  return {make_vec<N>([&](int j) { return floor_to<S>(box.center[j] - reach[j]); }),
          make_vec<N>([&](int j) { return ceil_to<S>(box.center[j] + reach[j]); })};
}

/// The smallest box around all parts of a compound.
template <class Shape, class... Shapes>
[[nodiscard]] constexpr auto bounding_box(const Compound<Shape, Shapes...>& compound) noexcept {
  auto box = detail::no_box<decltype(bounding_box(Shape()))>;
  for_each_part(compound, [&](const auto& part) { box = bounding_box(box, bounding_box(part)); });
  return box;
}

}  // namespace detent
