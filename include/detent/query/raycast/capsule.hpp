// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>

#include "detent/query/kernel/within_segment.hpp"
#include "detent/query/raycast/capsule/cylinder.hpp"
#include "detent/query/raycast/capsule/normal.hpp"
#include "detent/query/raycast/capsule/part.hpp"
#include "detent/query/raycast/hit.hpp"
#include "detent/query/raycast/sphere.hpp"

namespace detent {

namespace detail {

/// Where a ray enters a capsule. At an end, the sphere there gives the distance, if any.
template <Scalar S>
struct CapsuleEntry {
  CapsulePart part;
  std::optional<S> distance{};
};

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
  const auto axis = detail::facing_axis(ray, capsule);
  const auto [part, distance] = detail::with_cylinder(
      ray, axis, capsule.radius,
      [&](const auto& cylinder) { return detail::capsule_entry(cylinder, ray.max_distance); });
  if (!is_end(part)) return distance;
  return raycast(ray, detail::end_of(axis, capsule.radius, part));
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
  const auto axis = detail::facing_axis(ray, capsule);
  struct Entry {
    detail::CapsuleEntry<S> at;
    Direction<S, N> normal;
  };
  const Entry entry = detail::with_cylinder(ray, axis, capsule.radius, [&](const auto& cylinder) {
    const auto at = detail::capsule_entry(cylinder, ray.max_distance);
    const bool is_side = at.part == detail::CapsulePart::side && at.distance;
    return Entry{at,
                 is_side && capsule.radius > 0 ? detail::side_normal(cylinder) : -ray.direction};
  });
  const auto [part, distance] = entry.at;
  if (is_end(part)) return raycast_hit(ray, detail::end_of(axis, capsule.radius, part));
  if (!distance) return std::nullopt;
  return detail::hit_at(ray, *distance, entry.normal);
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
    // The sphere at the exit may lie wholly beyond the end of the ray.
    const detail::RaySphere<S, N> sphere(ray, detail::end_of(axis, capsule.radius, part));
    return (std::min)(sphere.quadratic().last_root(ray.max_distance), ray.max_distance);
  });
  return Interval<S>{*enter, exit};
}

}  // namespace detent
