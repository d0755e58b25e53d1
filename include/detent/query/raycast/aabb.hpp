// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "detent/query/kernel/clip.hpp"
#include "detent/query/raycast/hit.hpp"

namespace detent {

/// Distance along `ray` at which it first touches `box`, or nothing.
///
/// units:  lengths in world units; direction is unit length
/// domain: every input; a box with min > max on some axis is empty and never hit
/// result: 0 when the ray starts inside or on the box; a hit past max_distance is a miss
/// exact:  hit or miss exact; distance rounded down, error in [0, 1) ULP
///         (tests/oracle/ray_aabb.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<S> raycast(const Ray<S, N>& ray,
                                                 const Aabb<S, N>& box) noexcept {
  return detail::clip(ray, box).first_distance();
}

/// Distance, point and normal where `ray` first touches `box`, or nothing.
///
/// result: on an edge or corner, the normal of the lowest axis entered there
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<RayHit<S, N>> raycast_hit(const Ray<S, N>& ray,
                                                                const Aabb<S, N>& box) noexcept {
  const auto clip = detail::clip(ray, box);
  const auto distance = clip.first_distance();
  if (!distance) return std::nullopt;
  const int axis = clip.entered();
  if (axis == clip.no_slab) return detail::hit_at(ray, *distance, -ray.direction);
  const auto outward = Direction<S, N>::along(axis);
  return detail::hit_at(ray, *distance, ray.direction[axis] > 0 ? -outward : outward);
}

/// Distances at which `ray` enters and leaves `box`, or nothing.
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<Interval<S>> raycast_interval(
    const Ray<S, N>& ray, const Aabb<S, N>& box) noexcept {
  return detail::clip(ray, box).interval();
}

}  // namespace detent
