// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/kernel/argument.hpp"

namespace detent {

/// Where a moving shape first touches a target.
///
/// `distance` is how far it has moved, rounded down. `point` is the point of the target closest to
/// the moved shape; ties go to the least x, then y, then z. If they share points there, it is the
/// least one on a plane, and for an oriented box and a segment, sphere or capsule; for other shapes
/// it is the one that `closest_points(target, shape)` gives. `normal` is the target's normal at the
/// touch, facing the shape. If they share a point at the start, the distance is 0, `point` the
/// shape's first point (a center, end `a` or first corner) and `normal` the opposite of the
/// direction, like for a ray that starts inside a solid.
template <Scalar S, int N>
struct CastHit {
  S distance{};
  Vec<S, N> point;
  Direction<S, N> normal;

  [[nodiscard]] friend constexpr bool operator==(const CastHit&, const CastHit&) noexcept = default;
};

/// Appends to a digest: the fields in order.
template <class D, Scalar S, int N>
constexpr void append(D& digest, const CastHit<S, N>& hit) noexcept {
  digest.add(hit.distance, hit.point, hit.normal);
}

}  // namespace detent
