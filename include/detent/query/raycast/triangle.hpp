// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "detent/query/kernel/collapsed.hpp"
#include "detent/query/kernel/planar.hpp"
#include "detent/query/raycast/hit.hpp"

namespace detent {

namespace detail {

/// A ray's line against the plane of a 3D triangle, by determinants. With n = (b - a) x (c - a) and
/// det = -n . direction, u and v are det times the barycentric weights of b and c at the point
/// where they meet, and n . (origin - a) is det times its distance.
///
/// source: Moeller and Trumbore, Fast, Minimum Storage Ray-Triangle Intersection (1997)
template <Scalar S>
struct RayTriangle {
  constexpr RayTriangle(const Ray<S, 3>& ray, const Triangle<S, 3>& triangle) noexcept
      : edge_b(triangle.b - triangle.a),
        edge_c(triangle.c - triangle.a),
        from_a(ray.origin - triangle.a),
        p(cross(ray.direction, edge_c)),
        det(narrow_dot<volume_bits>(edge_b, p)) {}

  /// det u and det v: their signs give the side of two edges on which the line passes.
  [[nodiscard]] constexpr auto u() const noexcept { return narrow_dot<volume_bits>(from_a, p); }
  [[nodiscard]] constexpr auto v(const Direction<S, 3>& direction) const noexcept {
    return narrow<volume_bits>(dot(q(), direction));
  }
  [[nodiscard]] constexpr auto height() const noexcept { return dot(edge_c, q()); }
  [[nodiscard]] constexpr auto normal() const noexcept { return cross(edge_b, edge_c); }

  using Edge = decltype(Vec<S, 3>() - Vec<S, 3>());
  using Moment = decltype(cross(Direction<S, 3>(), Edge()));
  // |x| |y| |direction| < 3 2^(2B) (1 + 2^-13) for edges x and y whose components have B bits.
  static constexpr int volume_bits = bits_of<decltype(Edge::x)> + bits_of<decltype(Moment::x)> + 1;
  Edge edge_b, edge_c, from_a;
  Moment p;
  decltype(narrow_dot<volume_bits>(Edge(), Moment())) det;

 private:
  [[nodiscard]] constexpr auto q() const noexcept { return cross(from_a, edge_b); }
};

/// Where the line of `ray` crosses a triangle that it is not parallel to.
template <Scalar S>
[[nodiscard]] constexpr auto crossing(const RayTriangle<S>& meeting,
                                      const Direction<S, 3>& direction) noexcept {
  using Distance = Fraction<decltype(meeting.height()), decltype(RayTriangle<S>::det)>;
  using Result = std::optional<Distance>;
  const bool flip = meeting.det < 0;
  const auto oriented = [flip](const auto& x) { return flip ? narrow_negative(x) : x; };
  // Not const: GCC 12 keeps const objects of several words in memory.
  auto det = oriented(meeting.det);
  auto u = oriented(meeting.u());
  if (u < 0 || u > det) return Result();
  auto v = oriented(meeting.v(direction));
  if (v < 0 || u + v > det) return Result();
  return Result({oriented(meeting.height()), det});
}

/// The part of the line of `ray` in a triangle that is parallel to it or collapsed.
template <Scalar S>
[[nodiscard]] constexpr std::optional<PlanarSpan<S>> edge_on_span(
    const Ray<S, 3>& ray, const Triangle<S, 3>& triangle, const RayTriangle<S>& meeting) noexcept {
  const auto normal = meeting.normal();
  if (is_zero(normal)) return span(ray, collapsed(triangle));
  if (dot(normal, meeting.from_a) != 0) return std::nullopt;
  const int axis = longest_axis(normal);
  const auto inside = span(
      PlanarLine<S>{without(ray.origin, axis), without(ray.direction.vec(), axis)},
      Triangle{without(triangle.a, axis), without(triangle.b, axis), without(triangle.c, axis)});
  if (!inside) return std::nullopt;
  return inside->span;
}

/// Whether a 2D triangle has no area.
template <Scalar S>
[[nodiscard]] constexpr bool is_collapsed(const Triangle<S, 2>& triangle) noexcept {
  return cross(triangle.b - triangle.a, triangle.c - triangle.a) == 0;
}

template <Scalar S>
[[nodiscard]] constexpr std::optional<TriangleSpan<S>> span(
    const Ray<S, 2>& ray, const Triangle<S, 2>& triangle) noexcept {
  if (!is_collapsed(triangle)) {
    return span(PlanarLine<S>{ray.origin, ray.direction.vec()}, triangle);
  }
  const auto inside = span(ray, collapsed(triangle));
  if (!inside) return std::nullopt;
  return TriangleSpan<S>{*inside, 0};
}

}  // namespace detail

/// Distance along `ray` at which it first touches `triangle`, or nothing.
///
/// A ray in the triangle's plane hits where it first meets the triangle. With Facing::front, rays
/// hit only the side from which a, b, c appear counter-clockwise.
///
/// units:  lengths in world units; direction is unit length
/// domain: every input; a collapsed triangle is the segment or point that its corners span
/// result: 0 when the ray starts on the triangle; a hit past max_distance is a miss
/// exact:  hit or miss exact, so no ray slips between triangles that share an edge; distance
///         rounded down, error in [0, 1) ULP                (tests/oracle/ray_triangle.test.cpp)
template <Scalar S>
[[nodiscard]] constexpr std::optional<S> raycast(const Ray<S, 3>& ray,
                                                 const Triangle<S, 3>& triangle,
                                                 Facing facing = Facing::both) noexcept {
  const detail::RayTriangle<S> meeting(ray, triangle);
  if (facing == Facing::front && meeting.det <= 0) return std::nullopt;
  if (meeting.det == 0) {
    const auto inside = detail::edge_on_span(ray, triangle, meeting);
    if (!inside) return std::nullopt;
    return detail::first_distance(*inside, ray.max_distance);
  }
  auto distance = detail::crossing(meeting, ray.direction);
  if (!distance || distance->numerator < 0) return std::nullopt;
  return floor_within(*distance, ray.max_distance);
}

/// Distance, point and normal where `ray` first touches `triangle`, or nothing.
///
/// result: the normal is on the side of the ray; it is that of (b - a) x (c - a) for a ray in the
///         triangle's plane, and the opposite of the direction for a collapsed triangle
/// exact:  each component of the normal is the exact one rounded to nearest
///         (tests/oracle/ray_triangle.test.cpp)
template <Scalar S>
[[nodiscard]] constexpr std::optional<RayHit<S, 3>> raycast_hit(
    const Ray<S, 3>& ray, const Triangle<S, 3>& triangle, Facing facing = Facing::both) noexcept {
  const auto distance = raycast(ray, triangle, facing);
  if (!distance) return std::nullopt;
  const detail::RayTriangle<S> meeting(ray, triangle);
  const auto normal = direction_of<S>(meeting.normal());
  if (!normal) return detail::hit_at(ray, *distance, -ray.direction);
  return detail::hit_at(ray, *distance, meeting.det < 0 ? -*normal : *normal);
}

/// Distances at which `ray` enters and leaves `triangle`: equal, except for a ray in its plane.
template <Scalar S>
[[nodiscard]] constexpr std::optional<Interval<S>> raycast_interval(
    const Ray<S, 3>& ray, const Triangle<S, 3>& triangle, Facing facing = Facing::both) noexcept {
  const detail::RayTriangle<S> meeting(ray, triangle);
  if (meeting.det == 0 && facing == Facing::both) {
    const auto inside = detail::edge_on_span(ray, triangle, meeting);
    if (!inside) return std::nullopt;
    return detail::interval_of(*inside, ray.max_distance);
  }
  const auto distance = raycast(ray, triangle, facing);
  if (!distance) return std::nullopt;
  return Interval<S>{*distance, *distance};
}

/// Distance along `ray` at which it first touches the 2D `triangle`, which is solid, or nothing.
///
/// units:  lengths in world units; direction is unit length
/// domain: every input; a collapsed triangle is the segment or point that its corners span
/// result: 0 when the ray starts inside or on the triangle; a hit past max_distance is a miss
/// exact:  hit or miss exact; distance rounded down, error in [0, 1) ULP
///         (tests/oracle/ray_triangle.test.cpp)
template <Scalar S>
[[nodiscard]] constexpr std::optional<S> raycast(const Ray<S, 2>& ray,
                                                 const Triangle<S, 2>& triangle) noexcept {
  const auto inside = detail::span(ray, triangle);
  if (!inside) return std::nullopt;
  return detail::first_distance(inside->span, ray.max_distance);
}

/// Distance, point and normal where `ray` first touches the 2D `triangle`, or nothing.
///
/// result: the outward normal of the edge entered, in case of a tie the first of ab, bc, ca; the
///         opposite of the direction if the ray starts inside or the triangle has collapsed
/// exact:  each component of the normal is the exact one rounded to nearest
///         (tests/oracle/ray_triangle.test.cpp)
template <Scalar S>
[[nodiscard]] constexpr std::optional<RayHit<S, 2>> raycast_hit(
    const Ray<S, 2>& ray, const Triangle<S, 2>& triangle) noexcept {
  const auto inside = detail::span(ray, triangle);
  if (!inside) return std::nullopt;
  const auto distance = detail::first_distance(inside->span, ray.max_distance);
  if (!distance) return std::nullopt;
  const bool starts_inside = inside->span.enter.numerator <= 0;
  if (starts_inside || detail::is_collapsed(triangle)) {
    return detail::hit_at(ray, *distance, -ray.direction);
  }
  const auto edge = inside->entry_edge == 0   ? triangle.b - triangle.a
                    : inside->entry_edge == 1 ? triangle.c - triangle.b
                                              : triangle.a - triangle.c;
  // The perpendicular that faces the ray: (y, -x) . d is the cross product.
  const bool along = cross(ray.direction, edge) > 0;
  const auto normal = direction_of<S>(Vec{edge.y, narrow_negative(edge.x)});
  return detail::hit_at(ray, *distance, along ? -*normal : *normal);
}

/// Distances at which `ray` enters and leaves the 2D `triangle`, or nothing.
template <Scalar S>
[[nodiscard]] constexpr std::optional<Interval<S>> raycast_interval(
    const Ray<S, 2>& ray, const Triangle<S, 2>& triangle) noexcept {
  const auto inside = detail::span(ray, triangle);
  if (!inside) return std::nullopt;
  return detail::interval_of(inside->span, ray.max_distance);
}

}  // namespace detent
