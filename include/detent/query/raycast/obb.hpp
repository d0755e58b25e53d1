// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "detent/math/width.hpp"
#include "detent/query/kernel/clip.hpp"
#include "detent/query/raycast/hit.hpp"
#include "detent/shape/obb.hpp"

namespace detent {

namespace detail {

/// Returns use(clip), with the ray clipped by the slabs of a box. The distances to the slabs fit 64
/// bits if box and ray are at most 2^30 steps apart.
template <Scalar S, int N, class Use>
[[nodiscard]] constexpr auto with_clip(const Ray<S, N>& ray, const Obb<S, N>& box,
                                       const Use& use) noexcept {
  const auto clip_slabs = [&](const auto& to_center, const auto& half_extents) {
    using Gap = decltype(dot(to_center, ray.direction) - half_extents.x);
    using Speed = decltype(dot(ray.direction, ray.direction));
    RayClip<S, Gap, Speed, bits_of<Gap> + bits_of<Speed>> clip(ray.max_distance);
    for (int i = 0; i < N; ++i) {
      const auto& axis = box.rotation.axis(i);
      const auto middle = dot(to_center, axis);
      clip.keep(i, middle - half_extents[i], middle + half_extents[i], dot(ray.direction, axis));
    }
    return use(clip);
  };
  return by_width<30>(clip_slabs, box.center - ray.origin, box.half_extents);
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
  return detail::with_clip(ray, box, [](const auto& clip) { return clip.first_distance(); });
}

/// Distance, point and normal where `ray` first touches `box`, or nothing.
///
/// result: the normal is axis(i) or its opposite; on an edge or corner, that of the lowest axis
///         entered there
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<RayHit<S, N>> raycast_hit(const Ray<S, N>& ray,
                                                                const Obb<S, N>& box) noexcept {
  using Result = std::optional<RayHit<S, N>>;
  return detail::with_clip(ray, box, [&](const auto& clip) {
    const auto distance = clip.first_distance();
    if (!distance) return Result();
    const int axis = clip.entered();
    if (axis == clip.no_slab) return Result(detail::hit_at(ray, *distance, -ray.direction));
    const auto outward = box.rotation.axis(axis);
    const bool along = dot(ray.direction, outward) > 0;
    return Result(detail::hit_at(ray, *distance, along ? -outward : outward));
  });
}

/// Distances at which `ray` enters and leaves `box`, or nothing.
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<Interval<S>> raycast_interval(const Ray<S, N>& ray,
                                                                    const Obb<S, N>& box) noexcept {
  return detail::with_clip(ray, box, [](const auto& clip) { return clip.interval(); });
}

}  // namespace detent
