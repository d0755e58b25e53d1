// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "detent/query/kernel/span.hpp"
#include "detent/query/raycast/hit.hpp"
#include "detent/shape/plane.hpp"

namespace detent {

namespace detail {

/// speed * t = gap, where t is the distance at which a ray's line meets a plane.
template <Scalar S, int N>
struct RayPlane {
  // sqrt(3) 2^B (1 + 2^-13) + 2^B < 2^(B + 2), in units where a direction's component 1 is 2^0.
  static constexpr int gap_bits = bits_of<S> + bits_of<direction_component<S>> + 1;

  constexpr RayPlane(const Ray<S, N>& ray, const Plane<S, N>& plane) noexcept
      : gap(narrow_difference<gap_bits>(plane.offset, dot(plane.normal, ray.origin))),
        speed(dot(plane.normal, ray.direction)) {}

  /// The point where the line meets the plane, or the part of it up to `limit` if the plane
  /// contains it.
  [[nodiscard]] constexpr auto span(const S& limit) const noexcept {
    using Distance = Fraction<Gap, Speed>;
    using Result = std::optional<Span<Gap, Speed>>;
    if (speed != 0) {
      const Distance distance = make_fraction(gap, speed);
      return Result({distance, distance});
    }
    if (gap != 0) return Result();
    return Result({Distance{Gap(0), Speed(1)}, Distance{Gap(limit), Speed(1)}});
  }

  using Gap = decltype(narrow_difference<gap_bits>(S(), dot(Direction<S, N>(), Vec<S, N>())));
  using Speed = decltype(dot(Direction<S, N>(), Direction<S, N>()));
  Gap gap;
  Speed speed;
};

template <Scalar S, int N>
[[nodiscard]] constexpr bool is_hidden(const RayPlane<S, N>& meeting, Facing facing) noexcept {
  return facing == Facing::front && meeting.speed >= 0;
}

}  // namespace detail

/// Distance along `ray` at which it first touches `plane`, or nothing.
///
/// units:  lengths in world units; directions are unit length
/// domain: every input
/// result: 0 for a ray that starts in the plane, in any direction; a hit past max_distance is a
///         miss; with Facing::front, rays from behind and within the plane miss
/// exact:  hit or miss exact; distance rounded down, error in [0, 1) ULP
///         (tests/oracle/ray_plane.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<S> raycast(const Ray<S, N>& ray, const Plane<S, N>& plane,
                                                 Facing facing = Facing::both) noexcept {
  const detail::RayPlane<S, N> meeting(ray, plane);
  if (detail::is_hidden(meeting, facing)) return std::nullopt;
  if (ray.max_distance < 0) return std::nullopt;
  if (meeting.gap == 0) return S(0);
  const bool is_ahead = meeting.gap < 0 ? meeting.speed < 0 : meeting.speed > 0;
  if (!is_ahead) return std::nullopt;
  return floor_within(make_fraction(meeting.gap, meeting.speed), ray.max_distance);
}

/// Distance, point and normal where `ray` first touches `plane`, or nothing.
///
/// result: the plane's normal on the side of the ray, or as stored for a ray in the plane
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<RayHit<S, N>> raycast_hit(
    const Ray<S, N>& ray, const Plane<S, N>& plane, Facing facing = Facing::both) noexcept {
  const auto distance = raycast(ray, plane, facing);
  if (!distance) return std::nullopt;
  const bool from_behind = dot(plane.normal, ray.direction) > 0;
  return detail::hit_at(ray, *distance, from_behind ? -plane.normal : plane.normal);
}

/// Distances at which `ray` enters and leaves `plane`: equal, except for a ray within the plane.
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<Interval<S>> raycast_interval(
    const Ray<S, N>& ray, const Plane<S, N>& plane, Facing facing = Facing::both) noexcept {
  const detail::RayPlane<S, N> meeting(ray, plane);
  if (detail::is_hidden(meeting, facing)) return std::nullopt;
  const auto span = meeting.span(ray.max_distance);
  if (!span) return std::nullopt;
  return detail::interval_of(*span, ray.max_distance);
}

}  // namespace detent
