// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "detent/query/kernel/beyond.hpp"
#include "detent/query/raycast/hull.hpp"

namespace detent {

/// Distance along `ray` at which it first touches `frustum`, or nothing.
///
/// result: 0 when the ray starts inside or on the frustum; a hit past max_distance is a miss
/// exact:  as for the hull of the corners                           (tests/oracle/frustum.test.cpp)
template <Scalar S>
[[nodiscard]] constexpr std::optional<S> raycast(const Ray<S, 3>& ray,
                                                 const Frustum<S>& frustum) noexcept {
  if (detail::is_beyond(frustum, ray)) return std::nullopt;
  return raycast(ray, frustum.hull());
}

/// Distance, point and normal where `ray` first touches `frustum`, or nothing.
///
/// exact: as for the hull of the corners                            (tests/oracle/frustum.test.cpp)
template <Scalar S>
[[nodiscard]] constexpr std::optional<RayHit<S, 3>> raycast_hit(
    const Ray<S, 3>& ray, const Frustum<S>& frustum) noexcept {
  if (detail::is_beyond(frustum, ray)) return std::nullopt;
  return raycast_hit(ray, frustum.hull());
}

/// Distances at which `ray` enters and leaves `frustum`, or nothing.
///
/// exact: as for the hull of the corners                            (tests/oracle/frustum.test.cpp)
template <Scalar S>
[[nodiscard]] constexpr std::optional<Interval<S>> raycast_interval(
    const Ray<S, 3>& ray, const Frustum<S>& frustum) noexcept {
  if (detail::is_beyond(frustum, ray)) return std::nullopt;
  return raycast_interval(ray, frustum.hull());
}

}  // namespace detent
