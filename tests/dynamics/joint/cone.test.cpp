// SPDX-License-Identifier: MIT
// Cones and limits of twists: how well they hold, and that they add no energy.
#include <cmath>
#include <numbers>

#include "dynamics/joint/helpers.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

using std::numbers::pi;

template <Scalar S>
using Limbs = World<S, 3, Sphere, Obb, BallJoint, ConeJoint>;

/// The swing and the twist of a joint.
struct Pose {
  double swing = 0, twist = 0;
};

using Vec3d = std::array<double, 3>;
double dot(const Vec3d& a, const Vec3d& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vec3d cross(const Vec3d& a, const Vec3d& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Turns axis 0 of a by the shortest turn of axis 2 of a to that of b: the angle from there to axis
/// 0 of b is the twist.
template <Scalar S>
Pose pose_of(const Limbs<S>& world, const ConeJoint<S, 3>& joint) {
  const auto axis = [&](const BodyId& id, const Rotation<S, 3>& frame, int i) {
    const auto& state = detail::WorldAccess::bodies(world)[id.index].state;
    const auto axes = detail::axes_of<S, 3>(state.orientation);
    Vec3d v{};
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t j = 0; j < 3; ++j) {
        v[k] += static_cast<double>(axes[j][static_cast<int>(k)]) *
                static_cast<double>(frame.axis(i)[static_cast<int>(j)]);
      }
    }
    return v;
  };
  const auto z = axis(joint.a, joint.frame_a, 2), w = axis(joint.b, joint.frame_b, 2);
  const auto x = axis(joint.a, joint.frame_a, 0), u = axis(joint.b, joint.frame_b, 0);
  const auto n = cross(z, w);
  const double cosine = dot(z, w);
  Vec3d turned{};
  const auto across = cross(n, x);
  for (std::size_t k = 0; k < 3; ++k) {
    turned[k] = cosine * x[k] + across[k] + n[k] * dot(n, x) / (1 + cosine);
  }
  return {std::atan2(std::sqrt(dot(n, n)), cosine),
          std::atan2(dot(cross(turned, u), w), dot(turned, u))};
}

/// A box 2 units long whose end is joined to a fixed ball at the origin. It points along x, as axis
/// 2 of the joint does.
template <Scalar S>
struct Arm {
  Limbs<S> world;
  ConeJoint<S, 3> joint;
  JointId id{};
  double start = 0, highest = 0;  // energy
  double swing = 0, gap = 0;      // the greatest
  double least = 0, most = 0;     // of the twist

  template <class Change>
  Arm(bool falls, const Change& change) : world(settings(falls)) {
    BodyOptions<S, 3> options;
    joint.a = world.add(Sphere<S, 3>{{}, num<S>(0.1)}, fixed_body<S, 3>()).value_or(no_object);
    joint.frame_a = joint.frame_b = outward();
    joint.anchor_b = at<S, 3>(-1, 0);
    change(joint, options);
    const Obb<S, 3> box{at<S, 3>(1, 0), {S(1), num<S>(0.2), num<S>(0.3)}, {}};
    joint.b = world.add(box, options).value_or(no_object);
    id = world.add(joint).value_or(no_joint);
    start = highest = energy(world);
  }
  static WorldSettings<S, 3> settings(bool falls) {
    auto settings = sleepless<S, 3>();
    if (!falls) settings.gravity = {};
    return settings;
  }
  /// Axis 2 along x.
  static Rotation<S, 3> outward() {
    return Rotation<S, 3>::from_axis_angle(Direction<S, 3>::along(1), Angle<S>::turn(1, 4));
  }
  Pose pose() const { return pose_of(world, joint); }
  double position(int k) const { return static_cast<double>(world.position(joint.b)[k]); }
  void step(int ticks) {
    for (int t = 0; t < ticks; ++t) {
      world.step();
      const auto now = pose();
      swing = (std::max)(swing, now.swing);
      least = (std::min)(least, now.twist);
      most = (std::max)(most, now.twist);
      gap = (std::max)(gap, gap_of<ConeJoint<S, 3>>(world, id));
      highest = (std::max)(highest, energy(world));
    }
  }
};

/// An arm that drops from level.
template <Scalar S>
Arm<S> dropped(double cone, int ticks) {
  Arm<S> arm(true, [&](auto& joint, auto&) {
    joint.cone_angle = num<S>(cone);
    joint.has_limits = true;
    joint.lower = num<S>(-0.25);
    joint.upper = num<S>(0.25);
  });
  arm.step(ticks);
  return arm;
}

/// An arm without weight that turns, with a cone and limits of the twist.
template <Scalar S>
Arm<S> spinning(const std::array<double, 3>& spin, double cone, double lower, double upper,
                int ticks) {
  Arm<S> arm(false, [&](auto& joint, auto& options) {
    for (std::size_t i = 0; i < 3; ++i) options.angular_velocity[i] = num<S>(spin[i]);
    // The center moves on a circle about the joint: v = w x (1, 0, 0).
    options.velocity = {S(0), num<S>(spin[2]), num<S>(-spin[1])};
    joint.cone_angle = num<S>(cone);
    joint.has_limits = lower != upper;
    joint.lower = num<S>(lower);
    joint.upper = num<S>(upper);
  });
  arm.step(ticks);
  return arm;
}

}  // namespace

TEMPLATE_TEST_CASE("cone: a dropped arm stops at its cone", "", q16_16, q24_8, float, double) {
  for (const double wanted : {0.1, 0.5, 0.8, 1.2, 1.5}) {
    const double cone = static_cast<double>(num<TestType>(wanted));
    const auto arm = dropped<TestType>(cone, 300);
    const auto exact = dropped<double>(cone, 300);
    CAPTURE(cone, arm.swing, arm.pose().swing, arm.least, arm.most, arm.gap, arm.highest);
    CHECK(arm.swing > cone);
    CHECK(arm.swing < cone + 0.005);
    CHECK(std::fabs(arm.pose().swing - cone) < 0.001);
    CHECK(arm.most - arm.least < 0.0005);
    CHECK(arm.gap < 0.01);
    const bool is_coarse = std::is_same_v<TestType, q24_8>;
    CHECK(arm.highest < arm.start + (is_coarse ? 0.02 : 1e-4));
    const double apart = is_coarse ? 0.01 : 1e-4;
    for (int k = 0; k < 3; ++k) CHECK(std::fabs(arm.position(k) - exact.position(k)) < apart);
  }
}

TEST_CASE("cone: an arm that is hit by a ball stays in its cone") {
  using S = q16_16;
  for (const double speed : {5., 20., 60.}) {
    Arm<S> arm(false, [](auto& joint, auto&) { joint.cone_angle = num<S>(0.6); });
    BodyOptions<S, 3> thrown;
    thrown.velocity = {S(0), num<S>(speed), num<S>(speed / 2)};
    thrown.density = S(2);
    REQUIRE(arm.world.add(Sphere<S, 3>{at3(1.5, -1.5, -0.75), num<S>(0.3)}, thrown));
    arm.start = arm.highest = energy(arm.world);
    arm.step(300);
    CAPTURE(speed, arm.swing, arm.gap, arm.highest - arm.start);
    CHECK(arm.swing > 0.59);
    CHECK(arm.swing < 0.6 + 0.001 * speed);
    CHECK(arm.highest <= arm.start * (1 + 1e-6));
  }
}

TEST_CASE("cone: a twist stops at its limits, whatever its speed") {
  for (const double speed : {1., 10., 50., 200.}) {
    for (const double sign : {-1., 1.}) {
      const auto arm = spinning<q16_16>({sign * speed, 0, 0}, 0, -0.5, 0.7, 200);
      CAPTURE(speed, sign, arm.least, arm.most, arm.highest);
      CHECK(arm.least >= -0.5001);
      CHECK(arm.most <= 0.7001);
      CHECK(std::fabs(arm.pose().twist - (sign < 0 ? -0.5 : 0.7)) < 0.0001);
      CHECK(arm.highest <= arm.start * (1 + 1e-6));
      CHECK(energy(arm.world) < 1e-6);
    }
  }
}

TEST_CASE("cone: swing and twist are limited together, and without a cone the twist alone") {
  const auto exam = [](const std::array<double, 3>& spin, double cone, double band) {
    const auto arm = spinning<q16_16>(spin, cone, -0.3, 0.2, 600);
    const auto real = spinning<double>(spin, cone, -0.3, 0.2, 600);
    CAPTURE(spin[0], cone, arm.swing, arm.least, arm.most, arm.gap, arm.highest - arm.start);
    if (cone != 0) CHECK(arm.swing < cone + band);
    CHECK(arm.least > -0.3 - band);
    CHECK(arm.most < 0.2 + band);
    CHECK(arm.most > 0.19);
    CHECK(arm.highest <= arm.start * (1 + 1e-5));
    CHECK(std::fabs(arm.swing - real.swing) < 0.001);
    CHECK(std::fabs(arm.most - real.most) < 0.001);
  };
  exam({30, 6, 2}, 0.5, 0.01);
  exam({3, 6, 2}, 1.5, 0.01);
  exam({3, 6, 20}, 2.8, 0.01);
  exam({3, 6, 2}, 3.1, 0.01);
  exam({3, 0.01, 0.1}, 0, 0.001);
}

TEST_CASE("cone: an arm that starts outside of its limits comes back") {
  for (const bool is_opposite : {false, true}) {
    Arm<q16_16> arm(false, [&](auto& joint, auto&) {
      const auto turn = is_opposite ? Angle<q16_16>::turn(3, 4) : Angle<q16_16>::turn(1, 10);
      joint.frame_b = Rotation<q16_16, 3>::from_axis_angle(Direction<q16_16, 3>::along(1), turn);
      joint.cone_angle = num<q16_16>(0.4);
      joint.has_limits = true;
      joint.lower = num<q16_16>(0.1);
      joint.upper = num<q16_16>(0.3);
    });
    const auto start = arm.pose();
    CHECK(std::fabs(start.swing - (is_opposite ? pi : 0.3 * pi)) < 1e-3);
    arm.step(120);
    CAPTURE(is_opposite, arm.pose().swing, arm.pose().twist, arm.gap);
    CHECK(std::fabs(arm.pose().swing - 0.4) < 0.001);
    CHECK(arm.pose().twist > 0.099);
    CHECK(arm.pose().twist < 0.301);
  }
}

TEST_CASE("cone: without limits, or far from them, it is a ball joint, bit by bit") {
  using S = q16_16;
  const auto end = [](auto joint) {
    Limbs<S> world;
    BodyOptions<S, 3> options;
    options.angular_velocity = {num<S>(0.3), num<S>(-0.5), num<S>(0.2)};
    joint.a = world.add(Sphere<S, 3>{{}, num<S>(0.1)}, fixed_body<S, 3>()).value_or(no_object);
    joint.b = *world.add(Obb<S, 3>{at<S, 3>(1, 0), {S(1), num<S>(0.2), num<S>(0.3)}, {}}, options);
    joint.anchor_b = at<S, 3>(-1, 0);
    REQUIRE(world.add(joint));
    for (int t = 0; t < 40; ++t) world.step();
    const auto& state = detail::WorldAccess::bodies(world)[joint.b.index].state;
    return std::pair(to_array(state.place), to_array(state.orientation));
  };
  ConeJoint<S, 3> none, wide;
  none.cone_angle = S(0);
  none.lower = none.upper = S(1);
  wide.cone_angle = S(4);
  wide.has_limits = true;
  wide.lower = S(-4);
  wide.upper = S(4);
  const auto expected = end(BallJoint<S, 3>());
  CHECK(end(none) == expected);
  CHECK(end(wide) == expected);
}

TEST_CASE("cone: it breaks under a load greater than its force") {
  using S = q16_16;
  const auto survives = [](double force) {
    Arm<S> arm(true, [&](auto& joint, auto& options) {
      options.density = S(10);
      joint.cone_angle = num<S>(0.2);
      joint.break_force = num<S>(force);
    });
    for (int t = 0; t < 120; ++t) arm.world.step();
    CHECK((arm.world.joint_count() == 1) == arm.world.contains(arm.id));
    return arm.world.contains(arm.id);
  };
  // It weighs 48; stopping it takes more.
  CHECK(survives(5000));
  CHECK(!survives(100));
  CHECK(survives(0));
}

}  // namespace detent::test
