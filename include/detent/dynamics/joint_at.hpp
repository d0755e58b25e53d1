// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>

#include "detent/dynamics/world.hpp"

namespace detent {

/// A joint of two bodies whose anchors are both at a point of the world, and whose frames, if it
/// has frames, are both along the same axes of the world. Its other fields have their defaults: set
/// them, then add it to the world.
///
///     auto hinge = joint_at<HingeJoint>(world, wall, door, {2_q16_16, 5_q16_16});
///     hinge.motor_torque = 50_q16_16;
///     world.add(hinge);
///
/// domain: every joint but `DistanceJoint`, which has two points; without a body, its anchor is the
///         point itself, and the world refuses the joint
/// exact:  anchors and frames are those of `local_point` and `local_frame`
///                                                          (tests/dynamics/joint_at.test.cpp)
template <template <class, int> class Joint, class Storage, Scalar S, int N, class... Parts>
requires(detail::IsJoint<Joint<S, N>> && !std::same_as<Joint<S, N>, DistanceJoint<S, N>>)
    [[nodiscard]] constexpr Joint<S, N> joint_at(const BasicWorld<Storage, S, N, Parts...>& world,
                                                 const BodyId& a, const BodyId& b,
                                                 const Vec<S, N>& point,
                                                 const Rotation<S, N>& axes = {}) noexcept {
  Joint<S, N> joint;
  joint.a = a;
  joint.b = b;
  joint.anchor_a = world.local_point(a, point);
  joint.anchor_b = world.local_point(b, point);
  if constexpr (requires { joint.frame_a; }) {
    joint.frame_a = world.local_frame(a, axes);
    joint.frame_b = world.local_frame(b, axes);
  }
  return joint;
}

}  // namespace detent
