// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "bench/worlds/plans.hpp"
#include "detent/dynamics/dynamics.hpp"
#include "dynamics/stage.hpp"

namespace detent::bench {

/// The world built from a plan.
template <Scalar S>
struct Stage {
  using Physics = BasicWorld<Growing, S, 3, Sphere<S, 3>, Capsule<S, 3>, Obb<S, 3>, BodyHull<S, 3>,
                             BallJoint<S, 3>, HingeJoint<S, 3>>;
  Physics world;
  std::vector<Vec<S, 3>> points;
  std::optional<SolidHull<S, 3>> solid;
  std::vector<BodyId> ids;  // of the plan's items

  static Vec<S, 3> vec(const Vec<double, 3>& v) {
    return make_vec<3>([&](int i) { return test::num<S>(v[i]); });
  }

  explicit Stage(const Plan& plan) {
    WorldSettings<S, 3> settings;
    if (!plan.sleeps) settings.sleep_speed = S(0);
    world = Physics(settings);
    for (const auto& p : plan.hull) points.push_back(vec(p));
    solid = solid_hull(1, ConvexHull<S, 3>{points});
    for (const auto& item : plan.items) ids.push_back(add(item));
    for (const auto& link : plan.links) join(link, ids[link.a], ids[link.b]);
  }

  BodyId add(const Item& item) {
    BodyOptions<S, 3> options;
    if (!item.moves) options.motion = BodyMotion::fixed;
    options.density = test::num<S>(item.density);
    const auto axis = normalize(vec(item.axis));
    const auto rotation = Rotation<S, 3>::from_axis_angle(
        axis.value_or(Direction<S, 3>::along(1)), Angle<S>::from_radians(test::num<S>(item.angle)));
    const auto center = vec(item.at), half = vec(item.half);
    std::optional<BodyId> id;
    if (item.kind == Kind::box) {
      id = world.add(Obb<S, 3>{center, half, rotation}, options);
    } else if (item.kind == Kind::ball) {
      id = world.add(Sphere<S, 3>{center, half.x}, options);
    } else if (item.kind == Kind::capsule) {
      const auto up = make_vec<3>([&](int i) {
        return test::num<S>(static_cast<double>(rotation.axis(1)[i]) * item.half.y);
      });
      const auto end = [&](bool top) {
        return make_vec<3>(
            [&](int i) { return S(saturate_to<S>(top ? center[i] + up[i] : center[i] - up[i])); });
      };
      id = world.add(Capsule<S, 3>{end(false), end(true), half.x}, options);
    } else {
      id = world.add(BodyHull<S, 3>{&*solid, center, rotation}, options);
    }
    return id.value_or(no_object);
  }

  void join(const Link& link, const BodyId& a, const BodyId& b) {
    const auto set = [&](auto& joint) {
      joint.a = a;
      joint.b = b;
      joint.anchor_a = world.local_point(a, vec(link.at));
      joint.anchor_b = world.local_point(b, vec(link.at));
    };
    if (!link.is_hinge) {
      BallJoint<S, 3> joint;
      set(joint);
      (void)world.add(joint);
      return;
    }
    HingeJoint<S, 3> joint;
    set(joint);
    Rotation<S, 3> frame;
    if (link.axis.x != 0) {
      frame =
          Rotation<S, 3>::from_axis_angle(Direction<S, 3>::along(1), Angle<S>::from_degrees(S(90)));
    } else if (link.axis.y != 0) {
      frame =
          Rotation<S, 3>::from_axis_angle(Direction<S, 3>::along(0), Angle<S>::from_degrees(S(90)));
    }
    joint.frame_a = world.local_frame(a, frame);
    joint.frame_b = world.local_frame(b, frame);
    joint.has_limits = true;
    joint.lower = test::num<S>(-1.2);
    joint.upper = test::num<S>(1.2);
    (void)world.add(joint);
  }
};

}  // namespace detent::bench
