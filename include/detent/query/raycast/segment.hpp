// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "detent/query/kernel/planar.hpp"
#include "detent/query/raycast/hit.hpp"

namespace detent {

/// Distance along `ray` at which it first touches `segment`, or nothing.
///
/// units:  lengths in world units; direction is unit length
/// domain: every input; equal ends make the segment a point
/// result: 0 when the ray starts on the segment; a hit past max_distance is a miss
/// exact:  hit or miss exact, also for a ray along the segment; distance rounded down, error in
///         [0, 1) ULP                                           (tests/oracle/ray_segment.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<S> raycast(const Ray<S, N>& ray,
                                                 const Segment<S, N>& segment) noexcept {
  const auto inside = detail::span(ray, segment);
  if (!inside) return std::nullopt;
  return detail::first_distance(*inside, ray.max_distance);
}

/// Distance, point and normal where `ray` first touches `segment`, or nothing.
///
/// result: a segment has no normal of its own and gives the opposite of the direction
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<RayHit<S, N>> raycast_hit(
    const Ray<S, N>& ray, const Segment<S, N>& segment) noexcept {
  const auto distance = raycast(ray, segment);
  if (!distance) return std::nullopt;
  return detail::hit_at(ray, *distance, -ray.direction);
}

/// Distances at which `ray` enters and leaves `segment`: equal, except for a ray along it.
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<Interval<S>> raycast_interval(
    const Ray<S, N>& ray, const Segment<S, N>& segment) noexcept {
  const auto inside = detail::span(ray, segment);
  if (!inside) return std::nullopt;
  return detail::interval_of(*inside, ray.max_distance);
}

}  // namespace detent
