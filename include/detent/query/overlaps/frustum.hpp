// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/beyond.hpp"
#include "detent/query/overlaps/aabb_hull.hpp"
#include "detent/query/overlaps/capsule_hull.hpp"
#include "detent/query/overlaps/hull_hull.hpp"
#include "detent/query/overlaps/obb_hull.hpp"
#include "detent/query/overlaps/plane_hull.hpp"
#include "detent/query/overlaps/sphere_hull.hpp"
#include "detent/query/overlaps/triangle_hull.hpp"

namespace detent {

namespace detail {

/// A shape that can be tested against a frustum: it has `overlaps` with hulls, and can be culled.
template <class Shape, class S>
concept MeetsFrusta = Culled<Shape, S> &&
    requires(const Shape& shape, const ConvexHull<S, 3>& hull) {
  detent::overlaps(shape, hull);
};

}  // namespace detail

/// Whether `frustum` shares a point with `shape`: a sphere, AABB, OBB, triangle, capsule or hull.
///
/// Six planes reject first (`is_beyond`), then the hull of the corners decides.
///
/// domain: every input; an empty shape overlaps nothing
/// exact:  yes or no exact, for the hull of the corners; touching counts
///         (tests/oracle/frustum.test.cpp)
template <Scalar S, detail::MeetsFrusta<S> Shape>
[[nodiscard]] constexpr bool overlaps(const Frustum<S>& frustum, const Shape& shape) noexcept {
  return !detail::is_beyond(frustum, shape) && overlaps(frustum.hull(), shape);
}
template <Scalar S, detail::MeetsFrusta<S> Shape>
[[nodiscard]] constexpr bool overlaps(const Shape& shape, const Frustum<S>& frustum) noexcept {
  return overlaps(frustum, shape);
}

/// Two frusta, as two hulls.
template <Scalar S>
[[nodiscard]] constexpr bool overlaps(const Frustum<S>& a, const Frustum<S>& b) noexcept {
  return overlaps(a, b.hull());
}

/// A plane, with the normal exactly as stored.
template <Scalar S>
[[nodiscard]] constexpr bool overlaps(const Frustum<S>& frustum,
                                      const Plane<S, 3>& plane) noexcept {
  return overlaps(frustum.hull(), plane);
}
template <Scalar S>
[[nodiscard]] constexpr bool overlaps(const Plane<S, 3>& plane,
                                      const Frustum<S>& frustum) noexcept {
  return overlaps(frustum.hull(), plane);
}

}  // namespace detent
