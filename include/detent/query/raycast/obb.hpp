// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "detent/query/raycast/clip.hpp"
#include "detent/shape/obb.hpp"

namespace detent {

namespace detail {

template <Scalar S, int N>
[[nodiscard]] constexpr auto clip(const Ray<S, N>& ray, const Obb<S, N>& box) noexcept {
  const auto to_center = box.center - ray.origin;
  using Gap = decltype(dot(to_center, ray.direction) - box.half_extents.x);
  using Speed = decltype(dot(ray.direction, ray.direction));
  RayClip<S, Gap, Speed, bits_of<Gap> + bits_of<Speed>> clip(ray.max_distance);
  for (int i = 0; i < N; ++i) {
    const auto& axis = box.rotation.axis(i);
    const auto middle = dot(to_center, axis);
    clip.keep(i, middle - box.half_extents[i], middle + box.half_extents[i],
              dot(ray.direction, axis));
  }
  return clip;
}

}  // namespace detail

/// Distance along `ray` at which it first touches `box`, or nothing.
///
/// The box is {x : |dot(axis(i), x - center)| <= half_extents[i]} with its axes exactly as stored.
///
/// units:  lengths in world units; direction is unit length
/// domain: every input; a box with a negative half extent is empty and never hit
/// result: 0 when the ray starts inside or on the box; a hit past max_distance is a miss
/// exact:  hit or miss exact; distance rounded down, error in [0, 1) ULP
///         (tests/oracle/ray_obb.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<S> raycast(const Ray<S, N>& ray,
                                                 const Obb<S, N>& box) noexcept {
  return detail::clip(ray, box).first_distance();
}

/// Distance, point and normal where `ray` first touches `box`, or nothing.
///
/// result: the normal is axis(i) or its opposite; on an edge or corner that of the lowest axis
///         among those entered there
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<RayHit<S, N>> raycast_hit(const Ray<S, N>& ray,
                                                                const Obb<S, N>& box) noexcept {
  const auto clip = detail::clip(ray, box);
  const auto distance = clip.first_distance();
  if (!distance) return std::nullopt;
  const int axis = clip.entered();
  if (axis == clip.no_slab) return detail::hit_at(ray, *distance, -ray.direction);
  const auto outward = box.rotation.axis(axis);
  const bool along = dot(ray.direction, outward) > 0;
  return detail::hit_at(ray, *distance, along ? -outward : outward);
}

/// Distances at which `ray` enters and leaves `box`, or nothing.
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<Interval<S>> raycast_interval(const Ray<S, N>& ray,
                                                                    const Obb<S, N>& box) noexcept {
  return detail::clip(ray, box).interval();
}

}  // namespace detent
