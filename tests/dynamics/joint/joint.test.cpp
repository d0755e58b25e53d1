// SPDX-License-Identifier: MIT
// What joints constrain, and how well: q16_16 within stated bounds, and close to double.
#include <numbers>

#include "dynamics/joint/helpers.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

using std::numbers::pi;

template <int N>
using Dimension = std::integral_constant<int, N>;

/// Calls f in 2D and in 3D.
template <class F>
void in_both_dimensions(const F& f) {
  f(Dimension<2>());
  f(Dimension<3>());
}

/// Measurements of a scene.
struct Course {
  double start = 0, highest = 0, lowest = 0;  // energy
  double gap = 0;                             // the greatest of any joint
  std::vector<double> end;                    // the final position of the last body
};

template <class Joint, Scalar S, int N>
Course run(JointedWorld<S, N>& world, const std::vector<JointId>& ids, const BodyId& last,
           int ticks) {
  Course course;
  course.start = course.highest = course.lowest = energy(world);
  for (int t = 0; t < ticks; ++t) {
    world.step();
    const double now = energy(world);
    course.highest = (std::max)(course.highest, now);
    course.lowest = (std::min)(course.lowest, now);
    for (const auto& id : ids) course.gap = (std::max)(course.gap, gap_of<Joint>(world, id));
  }
  course.end = point_of(world, last, Vec<S, N>());
  return course;
}

double apart(const Course& a, const Course& b) {
  double most = 0;
  for (std::size_t k = 0; k < a.end.size(); ++k) {
    most = (std::max)(most, std::fabs(a.end[k] - b.end[k]));
  }
  return most;
}

/// Two boxes that swing from level, each 2 units long, and touch nothing.
template <class Joint, Scalar S, int N>
Course double_pendulum(int ticks) {
  JointedWorld<S, N> world(sleepless<S, N>());
  auto options = fixed_body<S, N>();
  options.collides_with = 0;
  const auto wall = add_small_ball<S, N>(world, 0, 0, 0.1, options);
  const auto upper = add_box<S, N>(world, 1, 0, 1, 0.2);
  const auto lower = add_box<S, N>(world, 3, 0, 1, 0.2);
  const auto first = world.add(joint_at<Joint>(world, wall, upper, 0, 0));
  const auto second = world.add(joint_at<Joint>(world, upper, lower, 2, 0));
  return run<Joint>(world, {*first, *second}, lower, ticks);
}

template <template <Scalar, int> class Joint, int N>
void check_double_pendulum() {
  const auto fixed = double_pendulum<Joint<q16_16, N>, q16_16, N>(2000);
  const auto real = double_pendulum<Joint<double, N>, double, N>(2000);
  const double swing = 40 * (N == 2 ? 0.8 : 0.32);  // from level to straight down
  CAPTURE(N, fixed.start, fixed.highest, fixed.gap, real.highest, real.gap);
  // Velocities are half a substep ahead of positions, as the first quarter swing shows.
  CHECK(fixed.highest - fixed.start < 0.004 * swing);
  CHECK(real.highest - real.start < 0.004 * swing);
  CHECK(fixed.gap < 0.007);
  CHECK(real.gap < 0.007);
  // Later they part: the motion is chaotic.
  const auto early = double_pendulum<Joint<q16_16, N>, q16_16, N>(300);
  const auto early_real = double_pendulum<Joint<double, N>, double, N>(300);
  CHECK(std::fabs(early.gap - early_real.gap) < 1e-5);
  CHECK(apart(early, early_real) < 3e-4);
}

/// A rope of 30 links that swings from level, with a weight of `mass` links at the end; optionally
/// with a one-piece rope next to it.
template <Scalar S, int N>
Course rope(double mass, int substeps, int ticks, bool has_cord = false) {
  JointedWorld<S, N> world(sleepless<S, N>(substeps));
  const BodyId wall = add_small_ball<S, N>(world, 0, 0, 0.1, fixed_body<S, N>());
  BodyId last = wall;
  std::vector<JointId> ids;
  for (int i = 0; i <= 30; ++i) {
    BodyOptions<S, N> options;
    if (i == 30) options.density = num<S>(mass);
    const auto next = add_box<S, N>(world, 0.125 + 0.25 * i, 0, 0.125, 0.0625, options);
    ids.push_back(*world.add(joint_at<BallJoint<S, N>>(world, last, next, 0.25 * i, 0)));
    last = next;
  }
  DistanceJoint<S, N> cord;
  cord.a = wall;
  cord.b = last;
  cord.most = num<S>(7.625);
  if (has_cord) REQUIRE(world.add(cord));
  return run<BallJoint<S, N>>(world, ids, last, ticks);
}

}  // namespace

TEST_CASE("joint: a double pendulum gains no energy, keeps its joints, and matches double") {
  in_both_dimensions([](auto dimension) {
    constexpr int N = decltype(dimension)::value;
    check_double_pendulum<BallJoint, N>();
    check_double_pendulum<HingeJoint, N>();
  });
}

TEST_CASE("joint: a rope of 30 with a heavy end holds and gains no energy") {
  in_both_dimensions([](auto dimension) {
    constexpr int N = decltype(dimension)::value;
    const auto exam = [&](double mass, int ticks, double gap, double gain) {
      const auto fixed = rope<q16_16, N>(mass, 8, ticks), real = rope<double, N>(mass, 8, ticks);
      const double link = N == 2 ? 0.25 * 0.125 : 0.25 * 0.125 * 0.125;
      const double swing = 10 * link * (mass * 7.5 + 30 * 3.75);
      CAPTURE(N, mass, swing, fixed.start, fixed.highest, fixed.lowest, fixed.gap, real.highest,
              real.gap, apart(fixed, real));
      CHECK(fixed.gap < gap);
      CHECK(fixed.highest - fixed.start < gain * swing);
      CHECK(std::fabs(fixed.gap - real.gap) < 1e-4);
      CHECK(apart(fixed, real) < 1e-3);
    };
    exam(1, 200, 0.0075, 0.001);
    exam(100, 400, 0.042, 0.031);  // then it folds, and worlds that differ a little part
    CHECK(rope<q16_16, N>(100, 8, 600).gap < 0.042);
    CHECK(rope<q16_16, N>(100, 8, 600, true).gap < 0.01);
    CHECK(rope<q16_16, N>(1000, 8, 600, true).gap < 0.01);
  });
}

TEST_CASE("joint: rods, ropes and springs keep their lengths") {
  in_both_dimensions([](auto dimension) {
    constexpr int N = decltype(dimension)::value;
    using S = q16_16;
    using Joint = DistanceJoint<S, N>;
    const auto length = [](double least, double most, double frequency, double depth) {
      JointedWorld<S, N> world(sleepless<S, N>());
      Joint joint;
      joint.a = add_small_ball<S, N>(world, 0, 0, 0.1, fixed_body<S, N>());
      joint.b = add_small_ball<S, N>(world, 0, -depth, 0.5);
      joint.least = num<S>(least);
      joint.most = num<S>(most);
      joint.length = num<S>(2);
      joint.frequency = num<S>(frequency);
      const auto id = world.add(joint);
      REQUIRE(id);
      for (int t = 0; t < 600; ++t) world.step();
      return gap_of<Joint>(world, *id);
    };
    CHECK(std::fabs(length(2, 2, 0, 2) - 2) < 0.001);  // a rod
    CHECK(std::fabs(length(0, 3, 0, 1) - 3) < 0.001);  // a rope, taut in the end
    CHECK(std::fabs(length(0, 100, 2, 2) - (2 + 10 / (16 * pi * pi))) < 0.005);  // g / (2 pi f)^2
    CHECK(std::fabs(length(0, 2, 0.5, 1) - 2) < 0.001);  // a spring on a rope
  });
}

TEST_CASE("joint: a rope can be slack, and a rod pushes") {
  using S = q16_16;
  for (const bool is_rod : {false, true}) {
    WorldSettings<S, 2> settings = sleepless<S, 2>();
    settings.gravity = {};
    JointedWorld<S, 2> world(settings);
    DistanceJoint<S, 2> joint;
    joint.a = add_small_ball<S, 2>(world, 0, 0, 0.1, fixed_body<S, 2>());
    BodyOptions<S, 2> options;
    options.velocity = at<S, 2>(-1, 0);
    joint.b = add_small_ball<S, 2>(world, 3, 0, 0.1, options);
    joint.least = num<S>(is_rod ? 3 : 1);
    joint.most = num<S>(3);
    REQUIRE(world.add(joint));
    for (int t = 0; t < 60; ++t) world.step();
    CHECK(std::fabs(static_cast<double>(world.position(joint.b).x) - (is_rod ? 3 : 2)) < 0.01);
    for (int t = 0; t < 120; ++t) world.step();
    CHECK(std::fabs(static_cast<double>(world.position(joint.b).x) - (is_rod ? 3 : 1)) < 0.01);
  }
}

namespace {

template <Scalar S, int N>
WorldSettings<S, N> weightless() {
  auto settings = sleepless<S, N>();
  settings.gravity = {};
  return settings;
}

/// The angle of a body's axis 0 from x, about z.
template <Scalar S, int N>
double angle_in(const JointedWorld<S, N>& world, const BodyId& body) {
  const auto x = world.rotation(body).axis(0);
  return std::atan2(static_cast<double>(x[1]), static_cast<double>(x[0]));
}

/// A bar on a hinge at the origin, without gravity.
template <Scalar S, int N>
struct Bar {
  JointedWorld<S, N> world{weightless<S, N>()};
  HingeJoint<S, N> joint;
  JointId id{};

  template <class Change>
  explicit Bar(const Change& change) {
    const auto wall = add_small_ball<S, N>(world, 0, 0, 0.1, fixed_body<S, N>());
    const auto bar = add_box<S, N>(world, 1, 0, 1, 0.25);
    joint = joint_at<HingeJoint<S, N>>(world, wall, bar, 0, 0);
    change(joint);
    id = world.add(joint).value_or(no_joint);
  }
  double spin() const {
    return static_cast<double>(world.angular_velocity(joint.b)[N == 2 ? 0 : 2]);
  }
  double angle() const { return angle_in(world, joint.b); }
  void step(int ticks) {
    for (int t = 0; t < ticks; ++t) world.step();
  }
};

}  // namespace

TEST_CASE("joint: a motor accelerates by its torque to its speed and stops at a limit") {
  in_both_dimensions([](auto dimension) {
    constexpr int N = decltype(dimension)::value;
    CAPTURE(N);
    Bar<q16_16, N> bar([](auto& joint) {
      joint.motor_speed = num<q16_16>(2);
      joint.motor_torque = num<q16_16>(1);
      joint.has_limits = true;
      joint.lower = num<q16_16>(-1);
      joint.upper = num<q16_16>(1.5);
    });
    // The inertia about the end is m (1 / 12 (4 + 0.25) + 1), with a mass of 1 in 2D, 0.5 in 3D.
    const double mass = N == 2 ? 1 : 0.5, inertia = mass * (4.25 / 12 + 1);
    bar.step(12);
    CHECK(std::fabs(bar.spin() - 0.2 / inertia) < 0.01);
    bar.joint.motor_torque = num<q16_16>(20);
    REQUIRE(bar.world.change(bar.id, bar.joint));
    bar.step(18);
    CHECK(std::fabs(bar.spin() - 2) < 0.002);
    bar.step(120);
    CHECK(std::fabs(bar.angle() - 1.5) < 0.005);
    CHECK(std::fabs(bar.spin()) < 0.001);
    bar.joint.motor_speed = num<q16_16>(-2);
    REQUIRE(bar.world.change(bar.id, bar.joint));
    bar.step(180);
    CHECK(std::fabs(bar.angle() + 1) < 0.005);
    bar.joint.has_limits = false;
    bar.joint.motor_torque = {};
    REQUIRE(bar.world.change(bar.id, bar.joint));
    bar.step(60);
    CHECK(std::fabs(bar.angle() + 1) < 0.005);
    const double gap = gap_of<HingeJoint<q16_16, N>>(bar.world, bar.id);
    CHECK(gap < 0.001);
  });
}

TEST_CASE("joint: a hinge in 3D keeps its axis under a load across it") {
  using S = q16_16;
  JointedWorld<S, 3> world(sleepless<S, 3>());
  const auto wall = add_small_ball<S, 3>(world, 0, 0, 0.1, fixed_body<S, 3>());
  // Both frames are rotated so that the axis points up; gravity would bend it.
  const auto bar = add_box<S, 3>(world, 1, 0, 1, 0.2);
  auto joint = joint_at<HingeJoint<S, 3>>(world, wall, bar, 0, 0);
  joint.frame_a = joint.frame_b =
      Rotation<S, 3>::from_axis_angle(Direction<S, 3>::along(0), Angle<S>::turn(-1, 4));
  joint.motor_speed = num<S>(3);
  joint.motor_torque = num<S>(5);
  const auto id = world.add(joint);
  REQUIRE(id);
  double tilt = 0;
  for (int t = 0; t < 300; ++t) {
    world.step();
    tilt = (std::max)(tilt, std::fabs(1 - static_cast<double>(world.rotation(bar).axis(1)[1])));
  }
  const double gap = gap_of<HingeJoint<S, 3>>(world, *id);
  CHECK(tilt < 1e-5);
  CHECK(gap < 1e-3);
  CHECK(std::fabs(static_cast<double>(world.angular_velocity(bar)[1]) - 3) < 0.01);
}

TEST_CASE("joint: welded boxes stay straight") {
  in_both_dimensions([](auto dimension) {
    constexpr int N = decltype(dimension)::value;
    const auto sag = [](auto scalar) {
      using S = decltype(scalar);
      JointedWorld<S, N> world(sleepless<S, N>());
      auto last = add_small_ball<S, N>(world, 0, 0, 0.1, fixed_body<S, N>());
      for (int i = 0; i < 4; ++i) {
        const auto next = add_box<S, N>(world, 0.5 + i, 0, 0.5, 0.25);
        REQUIRE(world.add(joint_at<WeldJoint<S, N>>(world, last, next, i, 0)));
        last = next;
      }
      for (int t = 0; t < 300; ++t) world.step();
      return -static_cast<double>(world.position(last).y);
    };
    const double fixed = sag(q16_16()), real = sag(double());
    CAPTURE(N, fixed, real);
    CHECK(fixed > 0);
    CHECK(fixed < 0.06);
    CHECK(std::fabs(fixed - real) < 1e-4);
  });
}

/// A box that a joint at its center turns about axis 2, without gravity.
template <template <Scalar, int> class Joint, Scalar S, int N>
struct Swinging {
  JointedWorld<S, N> world{weightless<S, N>()};
  Joint<S, N> joint;
  JointId id{};

  /// Turned by `start` from the frame of the fixed body, on a spring of 2 Hz.
  explicit Swinging(double start) {
    joint.a = add_small_ball<S, N>(world, 0, 0, 0.1, fixed_body<S, N>());
    joint.b = add_box<S, N>(world, 0, 0, 1, 0.25);
    const auto angle = Angle<S>::from_radians(num<S>(start));
    if constexpr (N == 2) {
      world.set_rotation(joint.b, Rotation<S, 2>::from_angle(angle));
    } else {
      const auto axis = Direction<S, 3>::along(2);
      world.set_rotation(joint.b, Rotation<S, 3>::from_axis_angle(axis, angle));
    }
    joint.frequency = S(2);
    joint.damping_ratio = S(0);
    id = world.add(joint).value_or(no_joint);
  }
  double angle() const { return angle_in(world, joint.b); }
};

TEST_CASE("joint: springs of hinges and welds swing at their frequency about their angle") {
  in_both_dimensions([](auto dimension) {
    constexpr int N = decltype(dimension)::value;
    CAPTURE(N);
    const auto check = [](auto swinging, auto real, double middle) {
      // At 2 Hz the angle from the middle is a cosine of period 30 ticks, but for the damping of
      // implicit springs.
      double most = 0, apart = 0;
      for (int t = 1; t <= 60; ++t) {
        swinging.world.step();
        real.world.step();
        const double angle = swinging.angle();
        if (t % 15 == 0) {
          const double side = t % 30 == 0 ? 1 : -1;
          CAPTURE(t, angle, middle);
          CHECK((angle - middle) * side > 0.25);
          CHECK((angle - middle) * side < 0.5);
        }
        most = (std::max)(most, std::fabs(angle - middle));
        apart = (std::max)(apart, std::fabs(angle - real.angle()));
      }
      CHECK(most < 0.5);
      CHECK(apart < 1e-5);
    };
    check(Swinging<WeldJoint, q16_16, N>(0.5), Swinging<WeldJoint, double, N>(0.5), 0);
    Swinging<HingeJoint, q16_16, N> hinge(0.8);
    Swinging<HingeJoint, double, N> real(0.8);
    hinge.joint.angle = num<q16_16>(0.3);
    real.joint.angle = 0.3;
    REQUIRE(hinge.world.change(hinge.id, hinge.joint));
    REQUIRE(real.world.change(real.id, real.joint));
    check(hinge, real, 0.3);
  });
}

TEST_CASE("joint: the spring of a hinge turns with at most the torque of its motor") {
  in_both_dimensions([](auto dimension) {
    constexpr int N = decltype(dimension)::value;
    CAPTURE(N);
    Bar<q16_16, N> bar([](auto& joint) {
      joint.angle = num<q16_16>(1);
      joint.frequency = num<q16_16>(20);
      joint.motor_torque = num<q16_16>(1);
      joint.motor_speed = num<q16_16>(-50);  // unused
    });
    const double mass = N == 2 ? 1 : 0.5, inertia = mass * (4.25 / 12 + 1);
    bar.step(12);  // far from its angle it applies all of it
    CHECK(std::fabs(bar.spin() - 0.2 / inertia) < 0.01);
    bar.joint.motor_torque = {};
    REQUIRE(bar.world.change(bar.id, bar.joint));
    bar.step(60);
    CHECK(std::fabs(bar.angle() - 1) < 0.001);
    bar.joint.frequency = num<q16_16>(2);
    bar.joint.has_limits = true;
    bar.joint.upper = num<q16_16>(0.25);
    REQUIRE(bar.world.change(bar.id, bar.joint));
    bar.step(120);  // a limit is stronger than such a spring
    CHECK(std::fabs(bar.angle() - 0.25) < 0.005);
  });
}

TEST_CASE("joint: a slider moves only along its axis, between its limits") {
  in_both_dimensions([](auto dimension) {
    constexpr int N = decltype(dimension)::value;
    using S = q16_16;
    using Joint = SliderJoint<S, N>;
    JointedWorld<S, N> world(sleepless<S, N>());
    Joint joint;
    joint.a = add_small_ball<S, N>(world, 0, 0, 0.1, fixed_body<S, N>());
    joint.b = add_box<S, N>(world, 1, 0, 0.5, 0.25);
    joint.anchor_b = at<S, N>(0.25, 0);
    joint.has_limits = true;
    joint.lower = num<S>(-1);
    joint.upper = num<S>(3);
    joint.motor_speed = num<S>(2);
    joint.motor_force = num<S>(100);
    const auto id = world.add(joint);
    REQUIRE(id);
    const auto place = [&] { return point_of(world, joint.b, joint.anchor_b); };
    for (int t = 0; t < 30; ++t) world.step();
    CHECK(std::fabs(place()[0] - 2.25) < 0.02);
    for (int t = 0; t < 90; ++t) world.step();
    CHECK(std::fabs(place()[0] - 3) < 0.003);  // the motor presses against the limit
    joint.motor_speed = num<S>(-2);
    REQUIRE(world.change(*id, joint));
    for (int t = 0; t < 180; ++t) world.step();
    CHECK(std::fabs(place()[0] + 1) < 0.003);
    CHECK(std::fabs(place()[1]) < 0.001);
    CHECK(static_cast<double>(world.rotation(joint.b).axis(0)[0]) > 1 - 1e-6);
    joint.motor_force = {};
    joint.has_limits = false;
    joint.frequency = num<S>(1);
    joint.length = num<S>(0.5);
    REQUIRE(world.change(*id, joint));
    for (int t = 0; t < 300; ++t) world.step();
    CHECK(std::fabs(place()[0] - 0.5) < 0.001);
  });
}

TEST_CASE("joint: a car drives on its wheels") {
  in_both_dimensions([](auto dimension) {
    constexpr int N = decltype(dimension)::value;
    using S = q16_16;
    JointedWorld<S, N> world(sleepless<S, N>());
    const auto ground = add_box<S, N>(world, 0, -1, 60, 1, fixed_body<S, N>());
    if constexpr (N == 3) {
      REQUIRE(world.remove(ground));
      REQUIRE(world.put(ground, Obb<S, 3>{at<S, 3>(0, -1), {S(60), S(1), S(60)}, {}},
                        fixed_body<S, 3>()));
    }
    const auto car = add_box<S, N>(world, 0, 1, 1.2, 0.3);
    std::vector<JointId> axles;
    for (const double x : {-0.8, 0.8}) {
      for (const double z : {-0.6, 0.6}) {
        if (N == 2 && z > 0) continue;
        Vec<S, N> center = at<S, N>(x, 0.5);
        if constexpr (N == 3) center.z = num<S>(z);
        BodyOptions<S, N> rubber;
        rubber.friction = num<S>(1.5);
        WheelJoint<S, N> joint;
        joint.a = car;
        joint.b = world.add(Sphere<S, N>{center, num<S>(0.4)}, rubber).value_or(no_object);
        joint.anchor_a = world.local_point(car, center);
        std::array<Direction<S, N>, std::size_t{N}> up{};  // axis 0 up
        up[0] = Direction<S, N>::along(1);
        up[1] = -Direction<S, N>::along(0);
        if constexpr (N == 3) up[2] = Direction<S, N>::along(2);
        joint.frame_a = Rotation<S, N>::from_axes(up);
        joint.frequency = num<S>(4);
        joint.damping_ratio = num<S>(0.7);
        joint.motor_speed = num<S>(-10);
        joint.motor_torque = num<S>(2);
        axles.push_back(*world.add(joint));
      }
    }
    for (int t = 0; t < 300; ++t) world.step();
    CAPTURE(N, world.position(car).x.raw(), world.velocity(car).x.raw());
    CHECK(std::fabs(static_cast<double>(world.velocity(car).x) - 4) < 0.05);  // 10 times 0.4
    CHECK(static_cast<double>(world.rotation(car).axis(0)[0]) > 0.999);
    for (const auto& id : axles) CHECK(gap_of<WheelJoint<S, N>>(world, id) < 0.1);
  });
}

TEST_CASE("joint: a soft ball joint drags a body to a point with at most its force") {
  in_both_dimensions([](auto dimension) {
    constexpr int N = decltype(dimension)::value;
    using S = q16_16;
    JointedWorld<S, N> world(sleepless<S, N>());
    BallJoint<S, N> joint;
    joint.a = add_small_ball<S, N>(world, 0, 0, 0.1, fixed_body<S, N>());
    joint.b = add_box<S, N>(world, 0, -2, 0.5, 0.5);
    joint.frequency = S(5);
    joint.max_force = S(20);
    joint.anchor_a = at<S, N>(2, 1);
    const auto id = world.add(joint);  // the box weighs 10
    REQUIRE(id);
    for (int t = 0; t < 400; ++t) world.step();
    CHECK(gap_of<BallJoint<S, N>>(world, *id) < 0.02);
    joint.max_force = S(9);
    REQUIRE(world.change(*id, joint));
    for (int t = 0; t < 120; ++t) world.step();
    CHECK(static_cast<double>(world.velocity(joint.b).y) < -1.5);  // it falls at 1 unit / s^2
    CHECK(static_cast<double>(world.velocity(joint.b).y) > -2.1);
  });
}

TEST_CASE("joint: a joint breaks under a load greater than its force") {
  in_both_dimensions([](auto dimension) {
    constexpr int N = decltype(dimension)::value;
    using S = q16_16;
    const auto survives = [](double force) {
      JointedWorld<S, N> world;
      const auto wall = add_small_ball<S, N>(world, 0, 0, 0.1, fixed_body<S, N>());
      const auto box = add_box<S, N>(world, 0, -1, 0.5, 0.5);
      auto joint = joint_at<BallJoint<S, N>>(world, wall, box, 0, 0);
      joint.break_force = num<S>(force);
      const auto id = world.add(joint);
      REQUIRE(id);
      std::size_t broken = 0;
      for (int t = 0; t < 60; ++t) {
        world.step();
        broken += world.broken_count();
        if (world.broken_count() != 0) CHECK(world.broken(0) == *id);
      }
      CHECK(broken == (world.contains(*id) ? 0 : 1));
      CHECK(world.joint_count() == (world.contains(*id) ? 1 : 0));
      CHECK((world.position(box).y < S(-2)) == !world.contains(*id));
      return world.contains(*id);
    };
    CHECK(survives(10.5));  // the box weighs 10
    CHECK(!survives(9.5));
    CHECK(survives(0));
  });
}

TEST_CASE("joint: joined bodies collide with each other only if allowed") {
  using S = q16_16;
  for (const bool collide : {false, true}) {
    JointedWorld<S, 2> world;
    const auto a = add_box<S, 2>(world, 0, 0, 1, 1, fixed_body<S, 2>());
    const auto b = add_box<S, 2>(world, 0.5, 1.5, 1, 1);
    auto joint = joint_at<DistanceJoint<S, 2>>(world, b, a, 0, 0);
    joint.most = S(100);
    joint.collide = collide;
    const auto id = world.add(joint);
    REQUIRE(id);
    world.step();
    CHECK((detail::WorldAccess::contacts(world).size() == 1) == collide);
    REQUIRE(world.remove(*id));
    world.step();
    CHECK(detail::WorldAccess::contacts(world).size() == 1);
  }
}

TEST_CASE("joint: joints connect islands, and changing them wakes their bodies") {
  using S = q16_16;
  JointedWorld<S, 2> world;
  const auto wall = add_small_ball<S, 2>(world, 0, 0, 0.1, fixed_body<S, 2>());
  const auto upper = add_box<S, 2>(world, 0, -1, 0.2, 1);
  const auto lower = add_box<S, 2>(world, 0, -3, 0.2, 1);
  const auto first = world.add(joint_at<BallJoint<S, 2>>(world, wall, upper, 0, 0));
  const auto second = world.add(joint_at<BallJoint<S, 2>>(world, upper, lower, 0, -2));
  REQUIRE((first && second));
  const auto rest = [&] {
    for (int t = 0; t < 100; ++t) world.step();
    REQUIRE(world.is_asleep(upper));
    REQUIRE(world.is_asleep(lower));
  };
  rest();
  const auto before = digest(world);
  for (int t = 0; t < 100; ++t) world.step();
  CHECK(digest(world) == before);
  SECTION("pushed") {
    world.set_velocity(lower, at<S, 2>(1, 0));
    world.step();
    CHECK(!world.is_asleep(upper));
  }
  SECTION("changed") {
    REQUIRE(world.change(*first, *world.find_joint<BallJoint<S, 2>>(*first)));
    CHECK(!world.is_asleep(upper));
    world.step();
    CHECK(!world.is_asleep(lower));
  }
  SECTION("removed") {
    REQUIRE(world.remove(*second));
    CHECK(!world.remove(*second));
    CHECK(!world.is_asleep(lower));
    for (int t = 0; t < 60; ++t) world.step();
    CHECK(world.position(lower).y < S(-5));
    CHECK(world.position(upper).y > S(-2));
  }
  SECTION("without its body") {
    REQUIRE(world.remove(upper));
    CHECK(world.joint_count() == 0);
    CHECK(!world.contains(*first));
    CHECK(!world.is_asleep(lower));
  }
}

TEST_CASE("joint: wrong ids and full worlds are refused") {
  using S = q16_16;
  BoundedWorld<Bounded<3>, S, 2, Sphere, BallJoint> world;
  const auto a = *world.add(Sphere<S, 2>{at<S, 2>(0, 0), S(1)});
  const auto b = *world.add(Sphere<S, 2>{at<S, 2>(3, 0), S(1)});
  BallJoint<S, 2> joint;
  joint.a = a;
  CHECK(!world.add(joint));
  joint.b = a;
  CHECK(!world.add(joint));
  joint.b = b;
  joint.b.generation = 77;
  CHECK(!world.add(joint));
  joint.b = b;
  CHECK(!world.put({0, 0}, joint));
  CHECK(!world.put({6, 1}, joint));
  for (int i = 0; i < 6; ++i) CHECK(world.add(joint));
  CHECK(!world.add(joint));
  CHECK(!world.put({0, 9}, joint));
  CHECK(!world.change({0, 9}, joint));
  CHECK(world.remove(JointId{2, 3}));
  const auto again = world.add(joint);
  REQUIRE(again);
  CHECK(again->index == 2);
  CHECK(again->generation == 7);
  for (int t = 0; t < 60; ++t) world.step();
  CHECK(world.joint_count() == 6);
}

// A world type without joints reserves no memory for them.
static_assert(
    std::is_empty_v<decltype(detail::JointTable<detail::JointGroup<Growing, q16_16, 2>>::list)>);
static_assert(std::is_empty_v<detail::JointGroup<Growing, q16_16, 2>>);
static_assert(World<q16_16, 2, Sphere>::joint_capacity == 0);

}  // namespace detent::test
