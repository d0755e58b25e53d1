// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>

#include "detent/query/kernel/within_segment.hpp"
#include "detent/query/raycast/capsule/cylinder.hpp"
#include "detent/query/raycast/capsule/entry_filter.hpp"
#include "detent/query/raycast/capsule/normal.hpp"
#include "detent/query/raycast/capsule/part.hpp"
#include "detent/query/raycast/hit.hpp"
#include "detent/query/raycast/sphere.hpp"

namespace detent {

namespace detail {

/// Where a ray enters a capsule, at a distance up to `limit`.
template <Scalar S, int N, Number L, Number R>
[[nodiscard]] constexpr CapsuleEntry<S> capsule_entry(const RayCylinder<S, N, L, R>& ray,
                                                      const S& limit) noexcept {
  if (ray.is_far()) return {CapsulePart::none};
  if (within_edge(ray.e, ray.m, ray.radius)) return {CapsulePart::inside, S(0)};
  const auto b = ray.approach();
  const auto c = ray.start();
  if (c <= 0) return {dot(ray.m, ray.e) < 0 ? CapsulePart::first_end : CapsulePart::last_end};
  if (b >= 0 || compare_products(square(ray.radius), ray.a, abs(ray.det), abs(ray.det)) < 0) {
    return {CapsulePart::none};
  }
  const LongQuadratic side(ray.a, b, c, ray.reach(), ray.ee);
  const auto part = entered_part(ray, side);
  if (part != CapsulePart::side) return {part};
  return {part, side.first_root(limit)};
}

/// The axis of a capsule, starting at the first end of `entry`.
template <Scalar S, int N>
struct AxisEntry {
  Segment<S, N> axis;
  CapsuleEntry<S> entry;
};

/// Where `ray` enters `capsule`, which must have a radius >= 0.
template <Scalar S, int N>
[[nodiscard]] constexpr AxisEntry<S, N> exact_axis_entry(const Ray<S, N>& ray,
                                                         const Capsule<S, N>& capsule) noexcept {
  const auto axis = facing_axis(ray, capsule);
  return {axis, with_cylinder(ray, axis, capsule.radius, [&](const auto& cylinder) {
            return capsule_entry(cylinder, ray.max_distance);
          })};
}
template <Scalar S, int N>
[[nodiscard]] constexpr AxisEntry<S, N> axis_entry(const Ray<S, N>& ray,
                                                   const Capsule<S, N>& capsule) noexcept {
  if constexpr (is_fixed<S> && filter_pays<S>) {
    const auto m = ray.origin - capsule.a, e = capsule.b - capsule.a;
    if (fits<29>(m) && fits<29>(e)) {
      const auto entry = decide_capsule_entry(ray.direction, at_most<29>(m), at_most<29>(e),
                                              capsule.radius, ray.max_distance);
      if (entry.is_sure) return {{capsule.a, capsule.b}, entry.value};
    }
  }
  return exact_axis_entry(ray, capsule);
}

/// The sphere about the end through which a ray enters or leaves a capsule.
template <Scalar S, int N>
[[nodiscard]] constexpr Sphere<S, N> end_of(const Segment<S, N>& axis, const S& radius,
                                            CapsulePart part) noexcept {
  return {part == CapsulePart::first_end ? axis.start : axis.end, radius};
}

}  // namespace detail

/// Distance along `ray` at which it first touches `capsule`, or nothing.
///
/// units:  lengths in world units (Q16.16: 1/65536); direction is unit length
/// domain: every input; a negative radius is an empty capsule and is never hit
/// result: 0 when the ray starts inside or on the capsule; a hit past max_distance is a miss
/// exact:  hit or miss exact; distance rounded down, error in [0, 1) ULP
///         (tests/oracle/ray_capsule.test.cpp)
/// source: the cylinder, Ericson, Real-Time Collision Detection, 5.3.7
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<S> raycast(const Ray<S, N>& ray,
                                                 const Capsule<S, N>& capsule) noexcept {
  if (capsule.radius < 0 || ray.max_distance < 0) return std::nullopt;
  const auto [axis, entry] = detail::axis_entry(ray, capsule);
  if (!is_end(entry.part)) return entry.distance;
  return raycast(ray, detail::end_of(axis, capsule.radius, entry.part));
}

/// Distance, point and normal where `ray` first touches `capsule`, or nothing.
///
/// exact:  normal within 1 ULP of 2^-30 (2^-14 in 16 bits), on the side within 0.501; a capsule of
///         radius 0 has no normal and gives the opposite of the direction
///         (tests/oracle/ray_capsule.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<RayHit<S, N>> raycast_hit(
    const Ray<S, N>& ray, const Capsule<S, N>& capsule) noexcept {
  if (capsule.radius < 0 || ray.max_distance < 0) return std::nullopt;
  const auto [axis, entry] = detail::axis_entry(ray, capsule);
  if (is_end(entry.part)) {
    return raycast_hit(ray, detail::end_of(axis, capsule.radius, entry.part));
  }
  if (!entry.distance) return std::nullopt;
  if (entry.part == detail::CapsulePart::inside || capsule.radius == 0) {
    return detail::hit_at(ray, *entry.distance, -ray.direction);
  }
  return detail::hit_at(ray, *entry.distance,
                        detail::with_cylinder(ray, axis, capsule.radius, [](const auto& cylinder) {
                          return detail::side_normal(cylinder);
                        }));
}

/// Distances at which `ray` enters and leaves `capsule`, or nothing.
///
/// exact:  both rounded down, error in [0, 1) ULP             (tests/oracle/ray_capsule.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<Interval<S>> raycast_interval(
    const Ray<S, N>& ray, const Capsule<S, N>& capsule) noexcept {
  const auto enter = raycast(ray, capsule);
  if (!enter) return std::nullopt;
  const auto axis = detail::facing_axis(ray, capsule);
  const auto exit = detail::with_cylinder(ray, axis, capsule.radius, [&](const auto& cylinder) {
    const auto part = detail::left_part(cylinder);
    if (part == detail::CapsulePart::side) return cylinder.side().last_root(ray.max_distance);
    // The sphere at the exit may lie entirely beyond the end of the ray.
    const detail::RaySphere<S, N> sphere(ray, detail::end_of(axis, capsule.radius, part));
    return (std::min)(sphere.quadratic().last_root(ray.max_distance), ray.max_distance);
  });
  return Interval<S>{*enter, exit};
}

}  // namespace detent
