// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <type_traits>

#include "detent/query/kernel/argument.hpp"
#include "detent/shape/aabb.hpp"
#include "detent/shape/frustum.hpp"
#include "detent/shape/obb.hpp"
#include "detent/shape/ray.hpp"
#include "detent/shape/segment.hpp"
#include "detent/shape/triangle.hpp"

// The first test of a frustum's queries: a shape that lies beyond one of the six planes is outside.
// It rejects most shapes that are outside; the hull decides the rest.

namespace detent::detail {

// least_along(normal, shape): a lower bound of dot(normal, x) over the points x of a nonempty
// shape. Each is exact unless it says otherwise.

template <Scalar S>
[[nodiscard]] constexpr auto least_along(const Direction<S, 3>& normal,
                                         const Vec<S, 3>& point) noexcept {
  return dot(normal, point);
}
template <Scalar S>
[[nodiscard]] constexpr auto least_along(const Direction<S, 3>& normal,
                                         const Segment<S, 3>& segment) noexcept {
  return (std::min)(dot(normal, segment.start), dot(normal, segment.end));
}
template <Scalar S>
[[nodiscard]] constexpr auto least_along(const Direction<S, 3>& normal,
                                         const Triangle<S, 3>& triangle) noexcept {
  return (std::min)({dot(normal, triangle.a), dot(normal, triangle.b), dot(normal, triangle.c)});
}
template <Scalar S>
[[nodiscard]] constexpr auto least_along(const Direction<S, 3>& normal,
                                         const Aabb<S, 3>& box) noexcept {
  return dot(normal, make_vec<3>([&](int i) { return normal[i] > 0 ? box.min[i] : box.max[i]; }));
}

/// Above the length of any direction, which is at most 1 + 2^-29, or 1 + 2^-13 for 16-bit scalars.
template <Scalar S>
inline constexpr auto longest_direction = [] {
  using Component = direction_component<S>;
  if constexpr (is_fixed<S>) {
    return Component::from_raw(Component(1).raw() + 4);
  } else {
    return Component(1);
  }
}();

/// A lower bound, using `longest_direction`.
template <Scalar S, Round Shape>
requires std::is_same_v<typename PointOf<Shape>::type, Vec<S, 3>>
[[nodiscard]] constexpr auto least_along(const Direction<S, 3>& normal,
                                         const Shape& shape) noexcept {
  return least_along(normal, ShapeFields<Shape>::core(shape)) - shape.radius * longest_direction<S>;
}

/// A lower bound: cosines are rounded up. The box is the one that its edges span.
template <Scalar S>
[[nodiscard]] constexpr auto least_along(const Direction<S, 3>& normal,
                                         const Obb<S, 3>& box) noexcept {
  using Component = direction_component<S>;
  const auto cosines = make_vec<3>(
      [&](int i) { return ceil_to<Component>(narrow_abs(dot(normal, box.rotation.axis(i)))); });
  return dot(normal, box.center) - dot(box.half_extents, cosines);
}

template <Scalar S>
[[nodiscard]] constexpr auto least_along(const Direction<S, 3>& normal,
                                         const ConvexHull<S, 3>& hull) noexcept {
  auto least = largest<decltype(dot(normal, Vec<S, 3>()))>;
  for (const auto& point : hull.points) least = (std::min)(least, dot(normal, point));
  return least;
}

/// A shape that six planes can reject.
template <class Shape, class S>
concept Culled = requires(const Direction<S, 3>& normal, const Shape& shape) {
  detail::least_along(normal, shape);
};

/// Whether one of the planes separates `shape` from `frustum`. If so, they share no point.
template <Scalar S, Culled<S> Shape>
[[nodiscard]] constexpr bool is_beyond(const Frustum<S>& frustum, const Shape& shape) noexcept {
  for (const auto& plane : frustum.planes()) {
    if (least_along(plane.normal, shape) > plane.reach) return true;
  }
  return false;
}

/// Whether a ray starts beyond one of the planes and does not come closer to it.
template <Scalar S>
[[nodiscard]] constexpr bool is_beyond(const Frustum<S>& frustum, const Ray<S, 3>& ray) noexcept {
  for (const auto& plane : frustum.planes()) {
    if (dot(plane.normal, ray.origin) > plane.reach && dot(plane.normal, ray.direction) >= 0) {
      return true;
    }
  }
  return false;
}

}  // namespace detent::detail
