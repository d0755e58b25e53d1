// SPDX-License-Identifier: MIT
#pragma once

// Whether a point is on a shape:
//   on(shape, point)            -> bool   exactly on a plane, segment, ray, triangle or hull
//   on(shape, point, tolerance) -> bool   within `tolerance` of any shape

#include "detent/query/kernel/point_aabb.hpp"
#include "detent/query/kernel/point_capsule.hpp"
#include "detent/query/kernel/point_frustum.hpp"
#include "detent/query/kernel/point_hull.hpp"
#include "detent/query/kernel/point_obb.hpp"
#include "detent/query/kernel/point_plane.hpp"
#include "detent/query/kernel/point_ray.hpp"
#include "detent/query/kernel/point_segment.hpp"
#include "detent/query/kernel/point_sphere.hpp"
#include "detent/query/kernel/point_triangle.hpp"
#include "detent/query/kernel/within_segment.hpp"
#include "detent/query/kernel/within_triangle.hpp"
#include "detent/shape/compound.hpp"
#include "detent/shape/frustum.hpp"

namespace detent {

/// Whether `point` is exactly on a thin shape, or in a 2D triangle or a hull. Another name for
/// `contains`.
template <Scalar S, int N>
[[nodiscard]] constexpr bool on(const Plane<S, N>& plane, const Vec<S, N>& point) noexcept {
  return detail::holds(plane, point);
}
template <Scalar S, int N>
[[nodiscard]] constexpr bool on(const Segment<S, N>& segment, const Vec<S, N>& point) noexcept {
  return detail::holds(segment, point);
}
template <Scalar S, int N>
[[nodiscard]] constexpr bool on(const Ray<S, N>& ray, const Vec<S, N>& point) noexcept {
  return detail::holds(ray, point);
}
template <Scalar S, int N>
[[nodiscard]] constexpr bool on(const Triangle<S, N>& triangle, const Vec<S, N>& point) noexcept {
  return detail::holds(triangle, point);
}
template <Scalar S, int N>
[[nodiscard]] constexpr bool on(const ConvexHull<S, N>& hull, const Vec<S, N>& point) noexcept {
  return detail::holds(hull, point);
}
template <Scalar S>
[[nodiscard]] constexpr bool on(const Frustum<S>& frustum, const Vec<S, 3>& point) noexcept {
  return detail::holds(frustum, point);
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
  return tolerance >= 0 && detail::within_reach(shape, point, tolerance);
}
template <Scalar S>
[[nodiscard]] constexpr bool on(const Frustum<S>& frustum, const Vec<S, 3>& point,
                                const S& tolerance) noexcept {
  return on(frustum.hull(), point, tolerance);
}
template <class... Shapes, Scalar S, int N>
[[nodiscard]] constexpr bool on(const Compound<Shapes...>& compound, const Vec<S, N>& point,
                                const S& tolerance) noexcept {
  return any_part(compound, [&](const auto& part) { return on(part, point, tolerance); });
}

}  // namespace detent
