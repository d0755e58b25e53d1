// SPDX-License-Identifier: MIT
// Joints with numbers from their whole range: assertions hold, and worlds stay valid.
#include "dynamics/draw.hpp"
#include "dynamics/joint/helpers.hpp"
#include "oracle/space.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

/// A world of all kinds of joints.
template <Scalar S, int N>
struct AllJoints {
  using World = JointedWorld<S, N>;
};
template <Scalar S>
struct AllJoints<S, 3> {
  using World = detent::World<S, 3, Sphere, Obb, DistanceJoint, BallJoint, HingeJoint, WeldJoint,
                              SliderJoint, WheelJoint, ConeJoint>;
};

template <Scalar S, int N>
BodyId add_any(typename AllJoints<S, N>::World& world, Random& random) {
  const Numbers<S, N> number{random, random.one_in(4)};
  BodyOptions<S, N> options;
  if (random.one_in(5)) {
    options.motion = random.coin() ? BodyMotion::fixed : BodyMotion::kinematic;
  }
  if (random.one_in(3)) options.density = number.any();
  if (random.one_in(4)) options.locked = static_cast<std::uint8_t>(random.below(64));
  options.velocity = number.point();
  for (auto& w : options.angular_velocity) w = number();
  if (random.coin()) {
    return world.add(Sphere<S, N>{number.point(), number.size()}, options).value_or(no_object);
  }
  Obb<S, N> box{number.point(), make_vec<N>([&](int) { return number.size(); }), {}};
  return world.add(box, options).value_or(no_object);
}

template <Scalar S, int N>
Rotation<S, N> any_frame(Random& random) {
  const auto angle = Angle<S>::turn(static_cast<int>(random.below(1000)), 1000);
  if constexpr (N == 2) {
    return Rotation<S, 2>::from_angle(angle);
  } else {
    return Rotation<S, 3>::from_euler(angle, Angle<S>::turn(1, 7), angle);
  }
}

template <class Joint, class Storage, Scalar S, int N, class... Parts>
void join_any(BasicWorld<Storage, S, N, Parts...>& world, const BodyId& a, const BodyId& b,
              Random& random) {
  const Numbers<S, N> number{random, random.one_in(3)};
  Joint joint;
  joint.a = a;
  joint.b = b;
  const auto draw = [&]<class T>(const char*, T& x) {
    if constexpr (std::is_same_v<T, S>) {
      if (!random.one_in(4)) x = random.one_in(3) ? number.any() : number();
    } else if constexpr (std::is_same_v<T, Rotation<S, N>>) {
      x = any_frame<S, N>(random);
    } else {
      x = number.point();
    }
  };
  detail::for_each_number(joint, draw);
  if (random.coin()) detail::for_each_spring_number(joint, draw);
  joint.collide = random.coin();
  if constexpr (requires { joint.has_limits; }) joint.has_limits = random.coin();
  (void)world.add(joint);
}

}  // namespace

TEMPLATE_TEST_CASE("joint: joints with any numbers step without harm", "", (Space<q16_16, 2>),
                   (Space<q16_16, 3>), (Space<q8_8, 2>), (Space<q8_8, 3>)) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  Random random(20261124);
  CAPTURE(random.seed());
  std::size_t joints = 0;
  for (int round = 0; round < 150; ++round) {
    CAPTURE(round);
    WorldSettings<S, N> settings;
    const Numbers<S, N> number{random, true};
    if (round % 4 == 0) settings.gravity = number.point();
    if (round % 8 == 0) settings.substeps = 500;
    typename AllJoints<S, N>::World world(settings);
    std::vector<BodyId> ids;
    for (int i = 0; i < 12; ++i) ids.push_back(add_any<S, N>(world, random));
    for (std::size_t i = 0; i + 1 < ids.size(); ++i) {
      const auto& a = ids[i];
      const auto& b = ids[random.one_in(3) ? 0 : i + 1];
      switch (random.below(N == 3 ? 7 : 6)) {
        case 0:
          join_any<DistanceJoint<S, N>>(world, a, b, random);
          break;
        case 1:
          join_any<BallJoint<S, N>>(world, a, b, random);
          break;
        case 2:
          join_any<HingeJoint<S, N>>(world, a, b, random);
          break;
        case 3:
          join_any<WeldJoint<S, N>>(world, a, b, random);
          break;
        case 4:
          join_any<SliderJoint<S, N>>(world, a, b, random);
          break;
        case 5:
          join_any<WheelJoint<S, N>>(world, a, b, random);
          break;
        default:
          if constexpr (N == 3) join_any<ConeJoint<S, N>>(world, a, b, random);
          break;
      }
    }
    for (int t = 0; t < (round % 8 == 0 ? 1 : 8); ++t) world.step();
    joints += world.joint_count();
    const auto& bodies = detail::WorldAccess::bodies(world);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      REQUIRE(is_unit(to_array(bodies[i].state.orientation)));
    }
    typename AllJoints<S, N>::World restored(settings);
    for (std::uint32_t i = 0; i < ids.size(); ++i) {
      if (bodies[i].motion == BodyMotion::fixed) restored = world;
    }
    REQUIRE(restore(restored, snapshot(world)) == Restored::yes);
    REQUIRE(digest(restored) == digest(world));
  }
  CHECK(joints > 800);
}

}  // namespace detent::test
