// SPDX-License-Identifier: MIT
// Scenes that stand, swing or fall, in q16_16 and in double, with golden digests: the figures of
// docs/dynamics.md, "Stability".
#include <numbers>

#include "dynamics/joint/helpers.hpp"
#include "dynamics/scenes.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

using std::numbers::pi;

template <Scalar S>
using FlatWorld = World<S, 2, Sphere, Obb, BodyHull, DistanceJoint, BallJoint>;

/// Measurements of a scene. `top` is the watched body.
struct Course {
  int rest = -1;                // the tick after which nothing is faster than 0.03 units per second
  double dx = 0, dy = 0;        // displacement of the top from start to end
  double highest = 0, gap = 0;  // of the top; the greatest of any joint
  double mean = 0;              // height of all bodies at the end
  double gain = 0;              // the greatest energy above the initial one, as a fraction
  std::uint64_t digest = 0;
};

template <class World>
double energy_of(const World& world) {
  double sum = 0;
  const double rate = detail::WorldAccess::rate(world);
  const auto& bodies = detail::WorldAccess::bodies(world);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const auto& body = bodies[i];
    if (!body.can_move()) continue;
    const double x = static_cast<double>(body.state.velocity.x) * rate;
    const double y = static_cast<double>(body.state.velocity.y) * rate;
    const double w = static_cast<double>(body.state.spin[0]) * rate;
    const double turning = w * w / static_cast<double>(body.inertia.inverse[0]);
    const double height = static_cast<double>(body.state.place.y) + 1;  // above any floor
    sum += static_cast<double>(body.mass) * ((x * x + y * y + turning) / 2 + 10 * height);
  }
  return sum;
}

template <Scalar S>
struct Flat {
  FlatWorld<S> world;
  std::vector<std::vector<Vec<S, 2>>> points;
  std::vector<SolidHull<S, 2>> solids;
  BodyId top{}, floor{};
  std::vector<JointId> balls;

  explicit Flat(int substeps = 4) : world(sleepless<S, 2>(substeps)) {
    points.reserve(16);
    solids.reserve(16);
    floor = add(box_at<S, 2>(0, -1, 50, 1), fixed_body<S, 2>());
  }
  template <class Shape>
  BodyId add(const Shape& shape, const BodyOptions<S, 2>& options = {}) {
    return world.add(shape, options).value_or(no_object);
  }
  void join(const BodyId& a, const BodyId& b, double x, double y) {
    BallJoint<S, 2> joint;
    joint.a = a;
    joint.b = b;
    joint.anchor_a = world.local_point(a, at<S, 2>(x, y));
    joint.anchor_b = world.local_point(b, at<S, 2>(x, y));
    balls.push_back(world.add(joint).value());
  }
  double gap() const {
    double most = 0;
    const auto& bodies = detail::WorldAccess::bodies(world);
    for (const auto& id : balls) {
      const auto& joint = *world.template find_joint<BallJoint<S, 2>>(id);
      double d[2] = {0, 0};
      for (const bool second : {false, true}) {
        const auto& state = bodies[second ? joint.b.index : joint.a.index].state;
        const auto& anchor = second ? joint.anchor_b : joint.anchor_a;
        const auto axes = detail::axes_of<S, 2>(state.orientation);
        for (int k = 0; k < 2; ++k) {
          const double x = static_cast<double>(state.place[k]) +
                           static_cast<double>(axes[0][k]) * static_cast<double>(anchor.x) +
                           static_cast<double>(axes[1][k]) * static_cast<double>(anchor.y);
          d[k] += second ? x : -x;
        }
      }
      most = (std::max)(most, std::hypot(d[0], d[1]));
    }
    return most;
  }
  double fastest() const {
    double most = 0;
    const auto& bodies = detail::WorldAccess::bodies(world);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const auto& state = bodies[i].state;
      for (const double v :
           {static_cast<double>(state.velocity.x), static_cast<double>(state.velocity.y),
            static_cast<double>(state.spin[0])}) {
        most = (std::max)(most, std::fabs(v));
      }
    }
    return most * detail::WorldAccess::rate(world);
  }
  Course run(int ticks) {
    Course course;
    const auto start = world.position(top);
    const double energy = energy_of(world);
    for (int t = 0; t < ticks; ++t) {
      world.step();
      if (fastest() > 0.03) {
        course.rest = -1;
      } else if (course.rest < 0) {
        course.rest = t;
      }
      course.gap = (std::max)(course.gap, gap());
      course.gain = (std::max)(course.gain, energy_of(world) / energy - 1);
      course.highest = (std::max)(course.highest, static_cast<double>(world.position(top).y));
    }
    course.dx = static_cast<double>(world.position(top).x) - static_cast<double>(start.x);
    course.dy = static_cast<double>(world.position(top).y) - static_cast<double>(start.y);
    const auto& bodies = detail::WorldAccess::bodies(world);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      course.mean += static_cast<double>(bodies[i].state.place.y);
    }
    course.mean /= static_cast<double>(bodies.size());
    course.digest = digest(world);
    return course;
  }
};

template <Scalar S>
Course stack_of_20() {
  Flat<S> scene(8);
  for (int i = 0; i < 20; ++i) scene.top = scene.add(box_at<S, 2>(0, 0.5 + i, 0.5, 0.5));
  return scene.run(300);
}

template <Scalar S>
Course thousand_on_two() {
  Flat<S> scene(16);
  BodyOptions<S, 2> heavy;
  heavy.density = S(1000);
  (void)scene.add(box_at<S, 2>(0, 0.5, 0.5, 0.5));
  (void)scene.add(box_at<S, 2>(0, 1.5, 0.5, 0.5));
  scene.top = scene.add(box_at<S, 2>(0, 2.5, 0.5, 0.5), heavy);
  return scene.run(300);
}

/// An arch of 9 hulls between the radii 4 and 5.
template <Scalar S>
Course arch() {
  Flat<S> scene;
  for (std::uint32_t i = 0; i < 9; ++i) {
    const double a = pi * i / 9, b = pi * (i + 1) / 9;
    auto& points = scene.points.emplace_back();
    for (const auto& [r, t] : {std::pair{4.0, a}, {5.0, a}, {5.0, b}, {4.0, b}}) {
      points.push_back(at<S, 2>(r * std::cos(t), r * std::sin(t)));
    }
    scene.solids.push_back(solid_hull(i + 1, ConvexHull<S, 2>{points}).value());
    const auto stone = scene.add(BodyHull<S, 2>{&scene.solids.back(), {}, {}});
    if (i == 4) scene.top = stone;
  }
  return scene.run(300);
}

/// 15 dominoes in a row; the first one is pushed, the last one is watched.
template <Scalar S>
Course dominoes() {
  Flat<S> scene;
  BodyOptions<S, 2> pushed;
  pushed.velocity = at<S, 2>(1.5, 0);
  pushed.angular_velocity = {S(-3)};
  for (int i = 0; i < 15; ++i) {
    const auto options = i == 0 ? pushed : BodyOptions<S, 2>();
    scene.top = scene.add(box_at<S, 2>(0.5 * i, 0.5, 0.05, 0.5), options);
  }
  return scene.run(400);
}

/// Five balls on rods of 4 units, 0.03 apart. The first one swings down from 60 degrees; the last
/// one is watched.
template <Scalar S>
Course cradle(int ticks) {
  Flat<S> scene(8);
  for (int i = 0; i < 5; ++i) {
    const double x = 1.03 * i, angle = i == 0 ? pi / 3 : 0;
    BodyOptions<S, 2> steel;
    steel.restitution = S(1);
    steel.friction = S(0);
    const auto ball =
        Sphere<S, 2>{at<S, 2>(x - 4 * std::sin(angle), 6 - 4 * std::cos(angle)), num<S>(0.5)};
    scene.top = scene.add(ball, steel);
    DistanceJoint<S, 2> rod;
    rod.a = scene.floor;
    rod.b = scene.top;
    rod.anchor_a = scene.world.local_point(scene.floor, at<S, 2>(x, 6));
    rod.least = rod.most = S(4);
    REQUIRE(scene.world.add(rod));
  }
  return scene.run(ticks);
}

/// 20 planks between two fixed ends, onto which three boxes fall. A plank in the middle is watched.
template <Scalar S>
Course bridge() {
  Flat<S> scene(8);
  auto last = scene.floor;
  for (int i = 0; i < 20; ++i) {
    const auto plank = scene.add(box_at<S, 2>(-9.5 + i, 6, 0.5, 0.125));
    scene.join(last, plank, -10 + i, 6);
    if (i == 10) scene.top = plank;
    last = plank;
  }
  scene.join(last, scene.floor, 10, 6);
  for (int i = 0; i < 3; ++i) (void)scene.add(box_at<S, 2>(2.0 * i - 2, 7.5, 0.5, 0.5));
  return scene.run(600);
}

/// 20 figures of ten boxes and balls each, falling onto each other.
template <Scalar S>
Course ragdolls(int ticks) {
  Flat<S> scene;
  for (int i = 0; i < 20; ++i) {
    const double x = 1.6 * (i % 5) - 3.2 + 0.1 * (i / 5), y = 2 + 2.6 * (i / 5);
    const auto part = [&](double dx, double dy, double w, double h) {
      return scene.add(box_at<S, 2>(x + dx, y + dy, w, h));
    };
    const auto torso = part(0, 0, 0.22, 0.4);
    scene.top = scene.add(Sphere<S, 2>{at<S, 2>(x, y + 0.6), num<S>(0.18)});
    scene.join(torso, scene.top, x, y + 0.41);
    for (const double side : {-1.0, 1.0}) {
      const auto upper = part(side * 0.42, 0.3, 0.18, 0.08),
                 lower = part(side * 0.8, 0.3, 0.18, 0.07);
      scene.join(torso, upper, x + side * 0.23, y + 0.3);
      scene.join(upper, lower, x + side * 0.61, y + 0.3);
      const auto thigh = part(side * 0.13, -0.65, 0.09, 0.23),
                 shin = part(side * 0.13, -1.13, 0.08, 0.23);
      scene.join(torso, thigh, x + side * 0.13, y - 0.41);
      scene.join(thigh, shin, x + side * 0.13, y - 0.89);
    }
  }
  return scene.run(ticks);
}

template <Scalar S>
using SolidWorld = World<S, 3, Obb, BodyHull>;

/// Kinetic energy in 3D, rotation included.
template <Scalar S>
double kinetic(const SolidWorld<S>& world, const BodyId& id) {
  const auto& body = detail::WorldAccess::bodies(world)[id.index];
  const double rate = detail::WorldAccess::rate(world);
  const auto axes = detail::axes_of<S, 3>(body.state.orientation);
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    double w = 0;
    for (int k = 0; k < 3; ++k) {
      w += static_cast<double>(axes[i][k]) *
           static_cast<double>(body.state.spin[static_cast<std::size_t>(k)]);
    }
    const double v = static_cast<double>(body.state.velocity[static_cast<int>(i)]);
    sum += v * v + w * w / static_cast<double>(body.inertia.inverse[i]);
  }
  return sum * rate * rate / 2;
}

/// How often axis 1 of a spinning body flipped, and the relative change of its energy.
struct Spun {
  int flips = 0;
  double least = 1, most = 1;
  double upright = 1;  // the least component y of axis 1
  std::uint64_t digest = 0;
};

template <Scalar S>
Spun spin(SolidWorld<S>& world, const BodyId& id, int ticks) {
  Spun spun;
  const double start = kinetic(world, id);
  double side = 1;
  for (int t = 0; t < ticks; ++t) {
    world.step();
    const double up = static_cast<double>(world.rotation(id).axis(1)[1]);
    spun.upright = (std::min)(spun.upright, up);
    if (up * side < -0.5) {
      side = -side;
      ++spun.flips;
    }
    const double now = kinetic(world, id) / start;
    spun.least = (std::min)(spun.least, now);
    spun.most = (std::max)(spun.most, now);
  }
  spun.digest = digest(world);
  return spun;
}

/// A weightless box with three different sides that spins about its middle axis.
template <Scalar S>
Spun handle() {
  WorldSettings<S, 3> settings;
  settings.gravity = {};
  SolidWorld<S> world(settings);
  BodyOptions<S, 3> options;
  options.angular_velocity = {num<S>(0.02), S(8), S(0)};
  const auto id = world.add(Obb<S, 3>{{}, {S(1), num<S>(0.5), num<S>(0.25)}, {}}, options);
  return spin(world, *id, 1200);
}

/// A slightly tilted cone on its tip, at 60 radians per second.
template <Scalar S>
Spun top() {
  SolidWorld<S> world(sleepless<S, 3>(8));
  auto fixed = fixed_body<S, 3>();
  fixed.friction = num<S>(0.1);
  (void)world.add(Obb<S, 3>{{S(0), S(-1), S(0)}, {S(9), S(1), S(9)}, {}}, fixed);
  std::vector<Vec<S, 3>> points{{S(0), S(0), S(0)}};
  for (int i = 0; i < 12; ++i) {
    points.push_back(
        {num<S>(0.5 * std::cos(pi * i / 6)), num<S>(0.5), num<S>(0.5 * std::sin(pi * i / 6))});
  }
  const auto solid = solid_hull(1, ConvexHull<S, 3>{points}).value();
  BodyOptions<S, 3> options;
  options.friction = num<S>(0.1);
  options.angular_velocity = {S(0), S(60), S(0)};
  const auto tilt = Rotation<S, 3>::from_axis_angle(Direction<S, 3>::along(0),
                                                    Angle<S>::from_radians(num<S>(0.1)));
  const auto id = world.add(BodyHull<S, 3>{&solid, {S(0), num<S>(0.01), S(0)}, tilt}, options);
  return spin(world, *id, 600);
}

/// The requirements for a scene in q16_16, and its greatest deviation from the scene in double.
struct Band {
  int rest;  // latest tick of rest; 0: it may keep moving
  double least_dy, most_dy, drift, gap, from_double;
};

void check(const Course& fixed, const Course& real, const Band& band, std::uint64_t golden) {
  CAPTURE(fixed.rest, fixed.dx, fixed.dy, fixed.highest, fixed.gap, fixed.gain);
  CAPTURE(real.rest, real.dx, real.dy, real.highest, real.gap, real.gain);
  if (band.rest > 0) {
    CHECK(fixed.rest >= 0);
    CHECK(fixed.rest <= band.rest);
  }
  CHECK(fixed.dy >= band.least_dy);
  CHECK(fixed.dy <= band.most_dy);
  CHECK(std::fabs(fixed.dx) <= band.drift);
  CHECK(fixed.gap <= band.gap);
  CHECK(fixed.gain < 1e-3);
  CHECK(real.gain < 1e-3);
  CHECK(std::fabs(fixed.dx - real.dx) <= band.from_double);
  CHECK(std::fabs(fixed.dy - real.dy) <= band.from_double);
  CHECK(fixed.digest == golden);
}

}  // namespace

TEST_CASE("standing: a stack of 20 stands") {
  check(stack_of_20<q16_16>(), stack_of_20<double>(), {20, -0.028, -0.024, 1e-4, 0, 5e-4},
        0x7948e1a262569b87u);
}

TEST_CASE("standing: a box of mass 1,000 stands on two of mass 1") {
  check(thousand_on_two<q16_16>(), thousand_on_two<double>(), {80, -0.06, -0.05, 1e-3, 0, 5e-4},
        0x990f6e042b415083u);
}

TEST_CASE("standing: an arch of hulls stands") {
  check(arch<q16_16>(), arch<double>(), {15, -0.012, -0.006, 1e-3, 0, 5e-4}, 0xc9807abc711810a2u);
}

TEST_CASE("standing: all dominoes fall") {
  check(dominoes<q16_16>(), dominoes<double>(), {200, -0.46, -0.44, 0.7, 0, 1e-3},
        0x98a6ff9e214604dcu);
}

TEST_CASE("standing: the last ball of a cradle swings as high as the first") {
  const auto fixed = cradle<q16_16>(600), real = cradle<double>(600);
  check(fixed, real, {0, -1, 2, 4, 0, 2e-3}, 0xc1f6b4b26b2161abu);
  CHECK(fixed.highest > 3.98);  // the first one started at 4
  CHECK(fixed.highest < 4);
}

TEST_CASE("standing: a bridge holds three boxes") {
  check(bridge<q16_16>(), bridge<double>(), {0, -0.9, -0.7, 0.01, 0.02, 5e-3}, 0xcc0dec6f8b372b2eu);
}

TEST_CASE("standing: 20 ragdolls stay whole") {
  // While tumbling they diverge from those in double: only the heap is alike.
  const auto fixed = ragdolls<q16_16>(120), real = ragdolls<double>(120);
  CAPTURE(fixed.gap, fixed.gain, fixed.mean, real.gap, real.gain, real.mean);
  for (const auto& course : {fixed, real}) {
    CHECK(course.gap < 0.1);
    CHECK(course.gain < 1e-3);
  }
  CHECK(std::fabs(fixed.mean - real.mean) < 0.15);
  CHECK(fixed.digest == 0xd9d9b92ba689ac62u);
}

TEST_CASE("standing: a T-handle keeps flipping and keeps its energy") {
  const auto fixed = handle<q16_16>(), real = handle<double>();
  CAPTURE(fixed.flips, fixed.least, fixed.most, real.flips, real.least, real.most);
  CHECK(fixed.flips == 7);
  CHECK(real.flips == 7);
  CHECK(fixed.least > 0.98);
  CHECK(fixed.most < 1.02);
  CHECK(fixed.digest == 0xd6f3fef21db8fad7u);
}

TEST_CASE("standing: a spinning top stays upright") {
  const auto fixed = top<q16_16>(), real = top<double>();
  CAPTURE(fixed.upright, fixed.least, fixed.most, real.upright, real.least, real.most);
  CHECK(fixed.upright > 0.99);
  CHECK(std::fabs(fixed.upright - real.upright) < 1e-3);
  CHECK(fixed.most < 1.001);
  CHECK(fixed.digest == 0xcd24e430b47538eau);
}

}  // namespace detent::test
