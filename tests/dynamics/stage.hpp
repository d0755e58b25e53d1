// SPDX-License-Identifier: MIT
#pragma once

#include "detent/dynamics/world.hpp"
#include "support/num.hpp"

namespace detent::test {

/// A point in q16_16.
inline Vec<q16_16, 3> at3(double x, double y, double z) { return at<q16_16, 3>(x, y, z); }

/// A box with this center and half extents; in 3D its depth equals its width, at z = 0.
template <Scalar S, int N>
Obb<S, N> box_of(double x, double y, double half_width, double half_height) {
  Obb<S, N> box{at<S, N>(x, y), at<S, N>(half_width, half_height), {}};
  if constexpr (N == 3) box.half_extents.z = num<S>(half_width);
  return box;
}

/// A fixed ball of radius 50 whose top is at the origin.
template <class Storage, Scalar S, int N, class... Shapes>
BodyId add_round_ground(BasicWorld<Storage, S, N, Shapes...>& world) {
  BodyOptions<S, N> fixed;
  fixed.motion = BodyMotion::fixed;
  return world.add(Sphere<S, N>{at<S, N>(0, -50), S(50)}, fixed).value_or(no_object);
}

/// A ball of radius 1.
template <class Storage, Scalar S, int N, class... Shapes>
BodyId add_ball(BasicWorld<Storage, S, N, Shapes...>& world, double x, double y,
                const BodyOptions<S, N>& options = {}) {
  return world.add(Sphere<S, N>{at<S, N>(x, y), S(1)}, options).value_or(no_object);
}

}  // namespace detent::test
