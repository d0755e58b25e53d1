// SPDX-License-Identifier: MIT
#pragma once

// Whether a point is on a shape:
//   on(shape, point)            -> bool   exactly on a plane, segment, ray, triangle or hull
//   on(shape, point, tolerance) -> bool   within `tolerance` of any shape

#include "detent/query/contains.hpp"
#include "detent/query/distance.hpp"

namespace detent {

/// Whether `point` is exactly on a thin shape, or in a 2D triangle or a hull. Another name for
/// `contains`.
template <Scalar S, int N>
[[nodiscard]] constexpr bool on(const Plane<S, N>& plane, const Vec<S, N>& point) noexcept {
  return contains(plane, point);
}
template <Scalar S, int N>
[[nodiscard]] constexpr bool on(const Segment<S, N>& segment, const Vec<S, N>& point) noexcept {
  return contains(segment, point);
}
template <Scalar S, int N>
[[nodiscard]] constexpr bool on(const Ray<S, N>& ray, const Vec<S, N>& point) noexcept {
  return contains(ray, point);
}
template <Scalar S, int N>
[[nodiscard]] constexpr bool on(const Triangle<S, N>& triangle, const Vec<S, N>& point) noexcept {
  return contains(triangle, point);
}
template <Scalar S, int N>
[[nodiscard]] constexpr bool on(const ConvexHull<S, N>& hull, const Vec<S, N>& point) noexcept {
  return contains(hull, point);
}

/// Whether the distance from `point` to `shape` is at most `tolerance`. For an `Obb` it is measured
/// in the frame of the box.
///
/// units:  world units
/// domain: every input; false for a negative tolerance and for an empty shape
/// exact:  yes or no exact           (tests/oracle/point_*.test.cpp, the file named by the shape)
template <class Shape, Scalar S, int N>
[[nodiscard]] constexpr bool on(const Shape& shape, const Vec<S, N>& point,
                                const S& tolerance) noexcept {
  return tolerance >= 0 && squared_distance(shape, point) <= square(tolerance);
}
template <Scalar S, int N>
[[nodiscard]] constexpr bool on(const Sphere<S, N>& sphere, const Vec<S, N>& point,
                                const S& tolerance) noexcept {
  if (sphere.radius < 0 || tolerance < 0) return false;
  const auto reach = sphere.radius + tolerance;
  return squared_distance(point, sphere.center) <= square(reach);
}
template <Scalar S, int N>
[[nodiscard]] constexpr bool on(const Capsule<S, N>& capsule, const Vec<S, N>& point,
                                const S& tolerance) noexcept {
  return capsule.radius >= 0 && tolerance >= 0 &&
         detail::is_near(Segment{capsule.a, capsule.b}, point, capsule.radius + tolerance);
}
template <Scalar S, int N>
[[nodiscard]] constexpr bool on(const Obb<S, N>& box, const Vec<S, N>& point,
                                const S& tolerance) noexcept {
  if (is_empty(box) || tolerance < 0) return false;
  const auto excess = detail::excess(box, point);
  for (int i = 0; i < N; ++i) {
    if (excess[i] > tolerance || excess[i] < -tolerance) return false;
  }
  // No component exceeds `tolerance`, on the grid of products with a direction, whose 1 is
  // 2^(b - 1).
  constexpr int bits = bits_of<S> - 1 + bits_of<direction_component<S>>;
  return squared_length(narrow<bits>(excess)) <= square(tolerance);
}
template <class... Shapes, Scalar S, int N>
[[nodiscard]] constexpr bool on(const Compound<Shapes...>& compound, const Vec<S, N>& point,
                                const S& tolerance) noexcept {
  return any_part(compound, [&](const auto& part) { return on(part, point, tolerance); });
}

}  // namespace detent
