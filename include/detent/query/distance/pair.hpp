// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <type_traits>

#include "detent/query/distance/aabb.hpp"
#include "detent/query/distance/hull.hpp"
#include "detent/query/distance/obb.hpp"
#include "detent/query/distance/plane.hpp"
#include "detent/query/distance/triangle.hpp"
#include "detent/query/kernel/argument.hpp"
#include "detent/query/kernel/convex_body.hpp"
#include "detent/query/kernel/gjk.hpp"
#include "detent/query/kernel/within_slabs.hpp"

namespace detent {

namespace detail {

template <class T, template <class, int> class Shape>
inline constexpr bool is_kind = false;
template <template <class, int> class Shape, class S, int N>
inline constexpr bool is_kind<Shape<S, N>, Shape> = true;

template <class T>
concept HasDistances = (IsShape<T> || IsSegment<T>)&&is_convex<T>;
template <class A, class B>
concept HaveDistance =
    HasDistances<A> && HasDistances<B> && std::is_same_v < typename PointOf<A>::type,
typename PointOf<B>::type > ;

// A shape is all points within its radius of its core: a sphere's center, a capsule's axis, or the
// shape itself.

template <class Shape>
[[nodiscard]] constexpr const Shape& core_of(const Shape& shape) noexcept {
  return shape;
}
template <Scalar S, int N>
[[nodiscard]] constexpr const Vec<S, N>& core_of(const Sphere<S, N>& sphere) noexcept {
  return sphere.center;
}
template <Scalar S, int N>
[[nodiscard]] constexpr Segment<S, N> core_of(const Capsule<S, N>& capsule) noexcept {
  return {capsule.a, capsule.b};
}

template <Scalar S>
[[nodiscard]] constexpr ConvexHull<S, 3> core_of(const Frustum<S>& frustum) noexcept {
  return frustum.hull();
}

template <class Shape>
[[nodiscard]] constexpr auto radius_of(const Shape& shape) noexcept {
  if constexpr (requires { shape.radius; }) {
    return shape.radius;
  } else {
    return decltype(PointOf<Shape>::type::x)(0);
  }
}

template <class Shape>
[[nodiscard]] constexpr bool has_points(const Shape& shape) noexcept {
  if constexpr (requires { is_empty(shape); }) {
    return !is_empty(shape);
  } else {
    return !(radius_of(shape) < 0);
  }
}

/// The squared distance from `plane` to a body: that of its nearer extreme corner, 0 between them.
template <Scalar S, int N, class Body>
[[nodiscard]] constexpr auto squared_gap_to_body(const Plane<S, N>& plane,
                                                 const Body& body) noexcept {
  const auto& n = plane.normal.vec();
  constexpr int bits = bits_of<decltype(body.some().x)> + 1;
  const auto height = [&](bool farthest) {
    return dot(n, body.template extreme<bits>(n, body.some(), farthest)) - plane.offset;
  };
  const auto lowest = height(false), highest = height(true);
  using Height = std::remove_cvref_t<decltype(lowest)>;
  const auto gap = lowest > 0 ? lowest : highest < 0 ? highest : Height();
  return Fraction{square(gap), squared_length(n)};
}

/// The squared distance of two planes, 0 unless they are parallel. Parallel normals may point either
/// way and differ in length: on axis i, where b's is not 0, the planes are
/// |a.offset b.normal[i] - b.offset a.normal[i]| / (|b.normal[i]| |a.normal|) apart.
template <Scalar S, int N>
[[nodiscard]] constexpr auto squared_gap_of_planes(const Plane<S, N>& a,
                                                   const Plane<S, N>& b) noexcept {
  const int i = longest_axis(b.normal.vec());
  const auto apart = a.offset * b.normal[i] - b.offset * a.normal[i];
  using Apart = std::remove_cvref_t<decltype(apart)>;
  const bool is_parallel = are_parallel(a.normal, b.normal.vec());
  return Fraction{square(is_parallel ? apart : Apart()),
                  square(b.normal[i]) * squared_length(a.normal)};
}

/// The squared distance of two boxes, which have a gap or none along each axis.
template <Scalar S, int N>
[[nodiscard]] constexpr auto squared_gap_of_boxes(const Aabb<S, N>& a,
                                                  const Aabb<S, N>& b) noexcept {
  using Gap = decltype(S() - S());
  return squared_length(make_vec<N>([&](int i) {
    return (std::max)({Gap(), Gap(a.min[i] - b.max[i]), Gap(b.min[i] - a.max[i])});
  }));
}

/// The squared distance from a box to a segment, in the frame of the box, which is its slabs.
template <Scalar S, int N>
[[nodiscard]] constexpr auto squared_gap_in_frame(const Obb<S, N>& box,
                                                  const Segment<S, N>& segment) noexcept {
  const auto in_frame = [&](const auto& v) {
    return make_vec<N>([&](int i) { return dot(box.rotation.axis(i), v); });
  };
  const auto center = in_frame(box.center - segment.start);
  const auto along = in_frame(segment.end - segment.start);
  const auto low = center - box.half_extents, high = center + box.half_extents;
  return squared_distance_from_slabs(low, high, along);
}

/// The squared distance of two cores that have points, as a `Fixed` or a `Fraction`.
template <class A, class B>
[[nodiscard]] constexpr auto squared_gap(const A& a, const B& b) noexcept {
  if constexpr (is_kind<A, Vec> && is_kind<B, Vec>) {
    return squared_distance(a, b);
  } else if constexpr (is_kind<A, Vec> || (is_kind<B, Plane> && !is_kind<A, Plane>) ||
                       (is_kind<A, Segment> && is_kind<B, Obb>)) {
    return squared_gap(b, a);
  } else if constexpr (is_kind<B, Vec>) {
    return squared_distance(a, b);
  } else if constexpr (is_kind<B, Plane>) {
    return squared_gap_of_planes(a, b);
  } else if constexpr (is_kind<A, Plane>) {
    return squared_gap_to_body(a, body_of(b));
  } else if constexpr (is_kind<A, Obb> && is_kind<B, Segment>) {
    return squared_gap_in_frame(a, b);
  } else if constexpr (is_kind<A, Aabb> && is_kind<B, Aabb>) {
    return squared_gap_of_boxes(a, b);
  } else {
    return squared_distance_between(body_of(a), body_of(b));
  }
}

}  // namespace detail

/// The distance between two shapes or segments, 0 if they share a point.
///
/// An oriented box is its slabs, and distances are measured in its frame, where the other shape is
/// a segment, a sphere or a capsule; to other shapes it is the box that its edges span.
///
/// units:  world units
/// domain: every input; clamped to the greatest scalar, which is the result if a shape is empty
/// exact:  rounded down, error in [0, 1) ULP                (tests/oracle/distance_pairs.test.cpp)
/// source: Gilbert, Johnson, Keerthi (1988), for polytopes: see query/kernel/gjk.hpp
template <class A, class B>
requires detail::HaveDistance<A, B>
[[nodiscard]] constexpr auto distance(const A& a, const B& b) noexcept {
  using S = decltype(detail::radius_of(a));
  if (!detail::has_points(a) || !detail::has_points(b)) return largest<S>;
  // Radii are on the grid, so they may be subtracted after the distance of the cores is rounded.
  // Both cores have a point in the range, so that distance is below 2 sqrt(3) times the greatest
  // coordinate.
  using Length = decltype(S() + S() + S());
  const auto apart =
      sqrt_floor<Length>(detail::squared_gap(detail::core_of(a), detail::core_of(b)));
  const auto beyond = apart - (detail::radius_of(a) + detail::radius_of(b));
  return beyond > 0 ? floor_to<S>(beyond) : S(0);
}

}  // namespace detent
