// SPDX-License-Identifier: MIT
#include "detent/dynamics/joint_at.hpp"

#include "detent/number/angle.hpp"
#include "detent/number/literals.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

using namespace detent::literals;
using S = q16_16;
using Flat = World<S, 2, Sphere, Obb, BallJoint, HingeJoint, WheelJoint, DistanceJoint>;

template <template <class, int> class Joint>
concept HasJointAt = requires(const Flat& world, BodyId id, Vec<S, 2> point) {
  joint_at<Joint>(world, id, id, point);
};
static_assert(HasJointAt<BallJoint> && !HasJointAt<DistanceJoint>);  // that has two points

}  // namespace

TEST_CASE("joint_at: anchors and frames are those of the point and the axes in both bodies") {
  Flat world;
  const auto turned = Rotation<S, 2>::from_angle(Angle<S>::from_degrees(30_q16_16));
  const auto up = Rotation<S, 2>::from_angle(Angle<S>::from_degrees(90_q16_16));
  const auto a = *world.add(Sphere<S, 2>{{1_q16_16, 2_q16_16}, 1_q16_16});
  const auto b = *world.add(Obb<S, 2>{{4_q16_16, 3_q16_16}, {1_q16_16, 1_q16_16}, turned});
  const Vec<S, 2> point{3_q16_16, 2.5_q16_16};

  const auto ball = joint_at<BallJoint>(world, a, b, point);
  CHECK(ball.a == a);
  CHECK(ball.b == b);
  CHECK(ball.anchor_a == Vec<S, 2>{2_q16_16, 0.5_q16_16});
  CHECK(ball.anchor_b == world.local_point(b, point));

  const auto wheel = joint_at<WheelJoint>(world, a, b, point, up);
  CHECK(wheel.anchor_a == ball.anchor_a);
  CHECK(wheel.frame_a == world.local_frame(a, up));
  CHECK(wheel.frame_b == world.local_frame(b, up));
  CHECK(world.add(wheel));

  // Without axes a hinge has the angle 0 where it is made, however its bodies are turned.
  const auto hinge = joint_at<HingeJoint>(world, a, b, point);
  CHECK(hinge.frame_b == world.local_frame(b, Rotation<S, 2>()));
  CHECK(!world.add(joint_at<HingeJoint>(world, a, BodyId{}, point)));
}

}  // namespace detent::test
