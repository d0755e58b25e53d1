// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "detent/dynamics/dynamics.hpp"
#include "dynamics/stage.hpp"

namespace detent::test {

template <Scalar S, int N>
using JointedWorld = World<S, N, Sphere, Obb, DistanceJoint, BallJoint, HingeJoint, WeldJoint,
                           SliderJoint, WheelJoint>;

template <Scalar S, int N>
BodyOptions<S, N> fixed_body() {
  BodyOptions<S, N> options;
  options.motion = BodyMotion::fixed;
  return options;
}

template <Scalar S, int N>
WorldSettings<S, N> sleepless(int substeps = 4) {
  WorldSettings<S, N> settings;
  settings.substeps = substeps;
  settings.sleep_speed = S(0);
  return settings;
}

/// A box at x, y; in 3D its depth equals its height.
template <Scalar S, int N>
BodyId add_box(JointedWorld<S, N>& world, double x, double y, double half_width, double half_height,
               const BodyOptions<S, N>& options = {}) {
  Obb<S, N> box{at<S, N>(x, y), at<S, N>(half_width, half_height), {}};
  if constexpr (N == 3) box.half_extents.z = num<S>(half_height);
  return world.add(box, options).value_or(no_object);
}
template <Scalar S, int N>
BodyId add_small_ball(JointedWorld<S, N>& world, double x, double y, double radius,
                      const BodyOptions<S, N>& options = {}) {
  return world.add(Sphere<S, N>{at<S, N>(x, y), num<S>(radius)}, options).value_or(no_object);
}

/// A joint at a world point, for the current poses of its bodies.
template <class Joint, Scalar S, int N>
Joint joint_at(const JointedWorld<S, N>& world, const BodyId& a, const BodyId& b, double x,
               double y) {
  Joint joint;
  joint.a = a;
  joint.b = b;
  joint.anchor_a = world.local_point(a, at<S, N>(x, y));
  joint.anchor_b = world.local_point(b, at<S, N>(x, y));
  return joint;
}

/// The world position of a body's point, from the body's exact state.
template <class Storage, Scalar S, int N, class... Parts>
std::vector<double> point_of(const BasicWorld<Storage, S, N, Parts...>& world, const BodyId& id,
                             const Vec<S, N>& anchor) {
  const auto& state = detail::WorldAccess::bodies(world)[id.index].state;
  const auto axes = detail::axes_of<S, N>(state.orientation);
  std::vector<double> point;
  for (int k = 0; k < N; ++k) {
    double x = static_cast<double>(state.place[k]);
    for (int i = 0; i < N; ++i) {
      x += static_cast<double>(axes[static_cast<std::size_t>(i)][k]) *
           static_cast<double>(anchor[i]);
    }
    point.push_back(x);
  }
  return point;
}

/// The distance between a joint's anchors.
template <class Joint, class World>
double gap_of(const World& world, const JointId& id) {
  const Joint& joint = *world.template find_joint<Joint>(id);
  const auto p = point_of(world, joint.a, joint.anchor_a);
  const auto q = point_of(world, joint.b, joint.anchor_b);
  double sum = 0;
  for (std::size_t k = 0; k < p.size(); ++k) sum += (q[k] - p[k]) * (q[k] - p[k]);
  return std::sqrt(sum);
}

/// Kinetic plus potential energy, for gravity along y.
template <class Storage, Scalar S, int N, class... Parts>
double energy(const BasicWorld<Storage, S, N, Parts...>& world) {
  double sum = 0;
  const auto& bodies = detail::WorldAccess::bodies(world);
  const double rate = detail::WorldAccess::rate(world);
  const double weight = -static_cast<double>(world.settings().gravity[1]);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const auto& body = bodies[i];
    if (!body.can_move()) continue;
    double v2 = 0;
    for (int k = 0; k < N; ++k) {
      const double v = static_cast<double>(body.state.velocity[k]) * rate;
      v2 += v * v;
    }
    // The squared gyration about the spin axis, in the body's frame, where it is diagonal for boxes
    // and balls.
    const auto axes = detail::axes_of<S, N>(body.state.orientation);
    for (std::size_t j = 0; j < body.state.spin.size(); ++j) {
      double w = static_cast<double>(body.state.spin[j]) * rate;
      if constexpr (N == 3) {
        w = 0;
        for (int k = 0; k < 3; ++k) {
          w += static_cast<double>(axes[j][k]) *
               static_cast<double>(body.state.spin[static_cast<std::size_t>(k)]) * rate;
        }
      }
      v2 += w * w / static_cast<double>(body.inertia.inverse[j]);
    }
    sum += static_cast<double>(body.mass) *
           (v2 / 2 + weight * static_cast<double>(body.state.place[1]));
  }
  return sum;
}

}  // namespace detent::test
