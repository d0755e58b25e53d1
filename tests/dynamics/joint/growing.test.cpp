// SPDX-License-Identifier: MIT
// Growing worlds, which solve four joints at once where the machine has vectors, have the bits of
// bounded ones, which never do.
#include <vector>

#include "detent/dynamics/dynamics.hpp"
#include "detent/dynamics/snapshot.hpp"
#include "dynamics/stage.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"
#include "support/scalars.hpp"

namespace detent::test {
namespace {

template <Scalar S>
Vec<S, 3> draw_vector(Random& random, int bits) {
  return make_vec<3>([&](int) {
    const auto end = std::int64_t{1} << bits;
    return random.number<S>(-end, end - 1);
  });
}
template <Scalar S>
Rotation<S, 3> draw_rotation(Random& random) {
  const auto angle = num<S>(static_cast<double>(random.between(-300, 300)) / 100);
  const auto axis = normalize(draw_vector<S>(random, S::frac)).value_or(Direction<S, 3>::along(0));
  return Rotation<S, 3>::from_axis_angle(axis, Angle<S>::from_radians(angle));
}

/// What all bodies of a scene may differ in.
struct Plan {
  std::uint64_t seed = 0;
  bool are_level = false;  // in a row, at the same height
  bool are_equal = false;  // in shape
  bool are_tilted = false;
  bool are_various = false;  // some fixed, kinematic or locked
  int speed_bits = 0;        // beyond the scalar's fractional bits
};

template <Scalar S>
WorldSettings<S, 3> settings_of(Random& random) {
  WorldSettings<S, 3> settings;
  settings.substeps = static_cast<int>(random.between(1, 3));
  if (random.coin()) settings.gravity = {};
  if (random.coin()) settings.sleep_speed = S(0);
  if (random.one_in(4)) settings.hold_distance = num<S>(random.coin() ? 0.25 : 0);
  return settings;
}

template <class World, Scalar S>
BodyId add_link(World& world, const Vec<S, 3>& at, Random& random, const Plan& plan) {
  BodyOptions<S, 3> options;
  Random shapes(plan.are_equal ? plan.seed : random.next());
  if (plan.are_various && random.one_in(4)) {
    options.motion = random.coin() ? BodyMotion::fixed : BodyMotion::kinematic;
  }
  if (plan.are_various && random.one_in(6)) options.locked = AxisLock::turn_x;
  if (!random.one_in(3)) options.velocity = draw_vector<S>(random, S::frac + plan.speed_bits);
  if (!random.one_in(3)) options.angular_velocity = to_array(draw_vector<S>(random, S::frac + 1));
  const auto size = [&] { return num<S>(static_cast<double>(shapes.between(25, 200)) / 100); };
  const auto is_ball = shapes.one_in(3);
  const auto rotation = plan.are_tilted ? draw_rotation<S>(random) : Rotation<S, 3>();
  const auto id = is_ball ? world.add(Sphere<S, 3>{at, size()}, options)
                          : world.add(Obb<S, 3>{at, {size(), size(), size()}, rotation}, options);
  return id.value_or(no_object);
}

template <class World, Scalar S>
void join(World& world, const BodyId& a, const BodyId& b, const Vec<S, 3>& at, Random& random) {
  const auto between = [&](auto joint) {
    joint.a = a;
    joint.b = b;
    joint.anchor_a = world.local_point(a, at);
    joint.anchor_b = world.local_point(b, at);
    if (random.coin()) joint.anchor_b.y = num<S>(0.1);
    return joint;
  };
  const auto framed = [&](auto joint) {
    const auto frame = draw_rotation<S>(random);
    joint.frame_a = world.local_frame(a, frame);
    joint.frame_b = world.local_frame(b, frame);
    return joint;
  };
  const auto kind = random.below(6);
  if (kind < 2) {
    auto ball = between(BallJoint<S, 3>{});
    if (random.one_in(6)) ball.frequency = S(2);
    (void)world.add(ball);
  } else if (kind < 4) {
    auto hinge = framed(between(HingeJoint<S, 3>{}));
    hinge.has_limits = random.coin();
    if (random.one_in(6)) hinge.motor_torque = S(5);
    (void)world.add(hinge);
  } else if (kind == 4) {
    auto cone = framed(between(ConeJoint<S, 3>{}));
    if (random.coin()) cone.cone_angle = num<S>(0.5);
    cone.has_limits = random.coin();
    cone.lower = num<S>(-0.25);
    (void)world.add(cone);
  } else {
    (void)world.add(framed(between(WeldJoint<S, 3>{})));
  }
}

/// Steps a random scene of joined bodies. Returns the digests after each tick.
template <class World, Scalar S>
std::vector<std::uint64_t> run(const Plan& plan, int ticks) {
  Random random(plan.seed);
  World world(settings_of<S>(random));
  std::vector<BodyId> ids;
  std::vector<Vec<S, 3>> places;
  for (int i = 0; i < 8; ++i) {
    const auto off = draw_vector<S>(random, S::frac + 1);
    const Vec<S, 3> at{S(3 * i - 12), plan.are_level ? S(0) : off.y, off.z};
    ids.push_back(add_link(world, at, random, plan));
    places.push_back(at);
  }
  for (std::size_t i = 0; i + 1 < ids.size(); ++i) {
    if (random.one_in(4)) continue;
    const auto at = nearest_to<S>(half(places[i] + places[i + 1]));
    join(world, ids[i], ids[i + 1], at, random);
  }
  std::vector<std::uint64_t> digests;
  for (int i = 0; i < ticks; ++i) {
    world.step();
    digests.push_back(digest(world));
  }
  return digests;
}

}  // namespace

TEMPLATE_TEST_CASE("joints: growing worlds have the bits of bounded ones", "", q16_16, q14_16,
                   q24_8, q8_8) {
  using S = TestType;
  using Lanes = World<S, 3, Sphere, Obb, BallJoint, HingeJoint, WeldJoint, ConeJoint>;
  using Alone =
      BoundedWorld<Bounded<8>, S, 3, Sphere, Obb, BallJoint, HingeJoint, WeldJoint, ConeJoint>;
  Random random(0x9806);
  const int rounds = DETENT_TEST_ALL ? 200 : 50;
  for (int i = 0; i < rounds; ++i) {
    Plan plan;
    plan.seed = random.next();
    plan.are_level = random.coin();
    plan.are_equal = random.coin();
    plan.are_tilted = random.coin();
    plan.are_various = random.coin();
    // In one of four scenes up to the end of the range, so that numbers are clamped.
    plan.speed_bits =
        static_cast<int>(random.between(-4, random.one_in(4) ? S::bits - S::frac - 1 : 3));
    CAPTURE(plan.seed, plan.are_level, plan.are_equal, plan.are_tilted, plan.are_various);
    REQUIRE(run<Lanes, S>(plan, 3) == run<Alone, S>(plan, 3));
  }
}

}  // namespace detent::test
