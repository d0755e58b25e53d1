// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "detent/query/kernel/stab.hpp"
#include "detent/query/raycast/hit.hpp"
#include "detent/shape/hull.hpp"

namespace detent {

/// Distance along `ray` at which it first touches `hull`, or nothing.
///
/// units:  lengths in world units; direction is unit length
/// domain: every input; a flat hull is the polygon, segment or point that its points span; one
///         without points is empty and never hit
/// result: 0 when the ray starts inside or on the hull; a hit past max_distance is a miss
/// exact:  hit or miss exact; distance rounded down, error in [0, 1) ULP
///         (tests/oracle/ray_hull.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<S> raycast(const Ray<S, N>& ray,
                                                 const ConvexHull<S, N>& hull) noexcept {
  if (is_empty(hull)) return std::nullopt;
  detail::Stab<S, N> stab(ray, hull.points);
  const auto entry = detail::entry(stab, ray.max_distance);
  if (!entry) return std::nullopt;
  return entry->distance;
}

/// Distance, point and normal where `ray` first touches `hull`, or nothing.
///
/// result: the normal is that of the face hit, on the side of the ray; on an edge or corner, that
///         of one of the faces there through which the ray could enter, chosen only by the order of
///         the points; the opposite of the direction if the ray starts inside or on the hull, lies
///         in the plane of a flat hull, or meets one that is a segment or a point
/// exact:  each component of the normal is the exact one rounded to nearest
///         (tests/oracle/ray_hull.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<RayHit<S, N>> raycast_hit(
    const Ray<S, N>& ray, const ConvexHull<S, N>& hull) noexcept {
  if (is_empty(hull)) return std::nullopt;
  detail::Stab<S, N> stab(ray, hull.points);
  const auto entry = detail::entry(stab, ray.max_distance);
  if (!entry) return std::nullopt;
  if (entry->starts_inside || !stab.is_face()) {
    return detail::hit_at(ray, entry->distance, -ray.direction);
  }
  const auto along = direction_of<S>(stab.normal());
  return detail::hit_at(ray, entry->distance, -along.value_or(ray.direction));
}

/// Distances at which `ray` enters and leaves `hull`, or nothing.
///
/// exact:  both rounded down, error in [0, 1) ULP             (tests/oracle/ray_hull.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<Interval<S>> raycast_interval(
    const Ray<S, N>& ray, const ConvexHull<S, N>& hull) noexcept {
  if (is_empty(hull)) return std::nullopt;
  detail::Stab<S, N> stab(ray, hull.points);
  const auto entry = detail::entry(stab, ray.max_distance);
  if (!entry) return std::nullopt;
  stab.go_to_last();
  const auto exit = floor_within(stab.distance(), ray.max_distance);
  return Interval<S>{entry->distance, exit.value_or(ray.max_distance)};
}

}  // namespace detent
