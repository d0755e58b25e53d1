// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <type_traits>

#include "detent/query/cast/hit.hpp"
#include "detent/query/cast/plane.hpp"
#include "detent/query/cast/point.hpp"
#include "detent/query/cast/question.hpp"
#include "detent/query/cast/touch.hpp"

namespace detent {

namespace detail {

template <class T>
concept CanMove = (IsShape<T> && is_convex<T> && !is_kind<T, Plane>) || IsSegment<T>;
template <class T>
concept CanBeHit = (IsShape<T> || IsSegment<T>)&&is_convex<T>;
template <class A, class B>
concept HaveCast = CanMove<A> && CanBeHit<B> && !MixedArguments<A, B>;

/// The first point of a shape: a center, end or corner.
template <class Shape>
[[nodiscard]] constexpr typename PointOf<Shape>::type first_point(const Shape& shape) noexcept {
  if constexpr (is_kind<Shape, Obb>) {
    return shape.center;
  } else {
    return body_of(core_of(shape)).some();
  }
}

/// The first touch of a shape that moves along `direction` with a target.
template <bool WithNormal, class A, class B, Scalar S, int N>
[[nodiscard]] constexpr std::optional<Touch<S, N>> first_touch(const A& a,
                                                               const Direction<S, N>& direction,
                                                               const S& limit,
                                                               const B& b) noexcept {
  if (limit < 0 || !has_points(a) || !has_points(b)) return std::nullopt;
  if constexpr (is_kind<A, Sphere> && is_kind<B, Sphere>) {
    return touch_of_spheres<WithNormal>(a, b, direction, limit);
  } else if constexpr (is_kind<A, Aabb> && is_kind<B, Aabb>) {
    return touch_of_boxes(a, b, direction, limit);
  } else {
    return with_motion(
        core_of(a), core_of(b), direction,
        [&](const auto& body_a, const auto& body_b, const auto& way, const auto& to_world) {
          constexpr bool is_round = requires { a.radius; }
          || requires { b.radius; };
          if constexpr (is_round) {
            const auto radius = radius_of(a) + radius_of(b);
            if (radius > 0) {
              return touch_of_round<WithNormal>(body_a, body_b, way, to_world, direction, limit,
                                                radius, S(radius_of(b)));
            }
          }
          return touch_of_polytopes<WithNormal, !is_round>(body_a, body_b, way, to_world, direction,
                                                           limit);
        });
  }
}

/// `raycast` for moving shapes: `cast` without point and normal.
template <class A, class B, Scalar S, int N>
requires HaveCast<A, B>
[[nodiscard]] constexpr std::optional<S> cast_distance(const A& shape,
                                                       const Direction<S, N>& direction,
                                                       const std::type_identity_t<S>& max_distance,
                                                       const B& target) noexcept {
  const auto touch = first_touch<false>(shape, direction, max_distance, target);
  if (!touch) return std::nullopt;
  return touch->distance;
}

}  // namespace detail

/// Where `shape`, moving along `direction` by at most `max_distance`, first touches `target`, or
/// nothing.
///
/// To segments, spheres and capsules, an oriented box is its slabs, in its frame; to other shapes
/// it is the box that its edges span.
///
/// units:  lengths in world units; the direction is a unit vector, used exactly as stored
/// domain: every input; empty shapes touch nothing, and a negative max_distance is a miss
/// result: a hit at 0 if they share a point at the start, touching included; a hit past
///         max_distance is a miss. Between two shapes without a radius, the normal is that of the
///         face of their Minkowski difference that the motion meets. If it meets only an edge or a
///         corner, it is that of one of the faces there through which it could enter, chosen only
///         by the order of the corners, and for two AABBs that of the lowest axis. If it slides
///         along a flat difference, it is the opposite of the direction
/// exact:  hit or miss exact; distance rounded down, error in [0, 1) ULP. Normals within 1 ULP of
///         2^-30 (2^-14 in 16 bits); those of planes as stored, those between shapes without a
///         radius rounded to nearest. Points of a sphere or capsule within 1/2 + 2^-12 ULP, others
///         rounded to nearest. One exception: if a shape slides along a target at exactly the
///         distance of its radius, and first comes that close less than 2^-32 grid units (2^-16 in
///         16 bits, 2^-6 for a capsule next to a box in its frame) before a multiple of the grid
///         unit, the distance may be that multiple (tests/oracle/cast_round.test.cpp,
///         tests/oracle/cast_polytopes.test.cpp)
template <class A, class B, Scalar S, int N>
requires detail::HaveCast<A, B>
[[nodiscard]] constexpr std::optional<CastHit<S, N>> cast(
    const A& shape, const Direction<S, N>& direction, const std::type_identity_t<S>& max_distance,
    const B& target) noexcept {
  const auto touch = detail::first_touch<true>(shape, direction, max_distance, target);
  std::optional<CastHit<S, N>> hit;
  if (!touch) return hit;
  hit.emplace();
  if (!touch->normal) {
    hit->point = detail::first_point(shape);
    hit->normal = -direction;
    return hit;
  }
  hit->distance = touch->distance;
  hit->normal = *touch->normal;
  hit->point = touch->point
                   ? *touch->point
                   : detail::closest_point_of_target(shape, target, direction, touch->distance);
  return hit;
}

/// `cast(question.shape, question.direction, question.max_distance, target)`.
template <class Shape, class Target>
[[nodiscard]] constexpr auto cast(const Cast<Shape>& question, const Target& target) noexcept {
  return cast(question.shape, question.direction, question.max_distance, target);
}

}  // namespace detent
