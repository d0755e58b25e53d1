// SPDX-License-Identifier: MIT
#pragma once

#include "detent/shape/ray.hpp"

namespace detent {

/// Where a ray first touches a shape.
///
/// `distance` is the exact one rounded down, so `point` lies on the surface or before it, except
/// for the rounding of its coordinates. `normal` is the normal at the exact point, facing the ray.
/// If the ray starts inside a solid, it is the opposite of the direction.
template <Scalar S, int N>
struct RayHit {
  S distance{};
  Vec<S, N> point;
  Direction<S, N> normal;

  [[nodiscard]] friend constexpr bool operator==(const RayHit&, const RayHit&) noexcept = default;
};

/// Appends to a digest: the fields in order.
template <class D, Scalar S, int N>
constexpr void append(D& digest, const RayHit<S, N>& hit) noexcept {
  digest.add(hit.distance, hit.point, hit.normal);
}

/// Which sides of a surface rays hit: both, or only the front, the side that its normal points to.
enum class Facing { both, front };

namespace detail {

template <Scalar S, int N>
[[nodiscard]] constexpr RayHit<S, N> hit_at(const Ray<S, N>& ray, const S& distance,
                                            const Direction<S, N>& normal) noexcept {
  return {distance, point_at(ray, distance), normal};
}

}  // namespace detail

}  // namespace detent
