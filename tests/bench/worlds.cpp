// SPDX-License-Identifier: MIT
//
// usage: detent-bench-worlds [--only q16_16|float|bullet] [--steps N] [--passes N] [--snapshots] [SCENE...]
// Steps scenes of bodies in q16_16, in float and in Bullet, which take turns step by step, and prints
// a table as CSV: milliseconds a step, the mean of steps 60 to 299 of the least of the passes. Sleeping
// is off, but for the scene "asleep". With --only it runs one of them, such as for a profiler. The
// last column is the digest of q16_16, which an optimisation must not change.

#include <time.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "detent/dynamics/dynamics.hpp"
#include "detent/dynamics/snapshot.hpp"
#include "dynamics/stage.hpp"
#include "support/random.hpp"

#ifdef DETENT_BENCH_BULLET
#include <btBulletDynamicsCommon.h>
#endif

namespace detent::bench {
namespace {

enum class Kind { box, ball, capsule, hull };

struct Item {
  Kind kind;
  bool moves;
  Vec<double, 3> at;
  Vec<double, 3>
      half;  // a ball's radius, and a capsule's radius and half height along y, come first
  Vec<double, 3> axis{0, 1, 0};
  double angle = 0;
};

/// A point of two bodies; a hinge turns about `axis` only.
struct Link {
  std::uint32_t a, b;
  Vec<double, 3> at;
  bool is_hinge = false;
  Vec<double, 3> axis{0, 0, 1};
};

struct Plan {
  std::string name;
  std::vector<Item> items{};
  std::vector<Link> links{};
  int steps = 300;
  bool sleeps = false;

  std::uint32_t add(const Item& item) {
    items.push_back(item);
    return static_cast<std::uint32_t>(items.size() - 1);
  }
  void ground(double half) { add({Kind::box, false, {0, -1, 0}, {half, 1, half}}); }
  void box(double x, double y) { add({Kind::box, true, {x, y, 0}, {0.5, 0.5, 0.5}}); }
};

/// The corners of a jittered icosahedron.
std::vector<Vec<double, 3>> hull_points() {
  test::Random random(12);
  const double g = (1 + std::sqrt(5.0)) / 2, length = std::sqrt(1 + g * g);
  std::vector<Vec<double, 3>> points;
  const auto add = [&](double x, double y, double z) {
    const double r = 0.6 * (1 + static_cast<double>(random.between(-120, 120)) / 1000) / length;
    points.push_back({x * r, y * r, z * r});
  };
  for (const double a : {-1.0, 1.0}) {
    for (const double b : {-g, g}) {
      add(0, a, b);
      add(a, b, 0);
      add(b, 0, a);
    }
  }
  return points;
}

Plan stack(int count) {
  Plan plan{"stack of " + std::to_string(count)};
  plan.ground(60);
  for (int i = 0; i < count; ++i) plan.box(0, 0.5 + i);
  return plan;
}

Plan pyramid(int base) {
  Plan plan{"pyramid of base " + std::to_string(base)};
  plan.ground(60);
  for (int row = 0; row < base; ++row) {
    for (int i = 0; i < base - row; ++i) plan.box((i - (base - row - 1) / 2.0) * 1.05, 0.5 + row);
  }
  return plan;
}

Plan heap(std::string name, Kind kind, int wide, int high, int deep) {
  Plan plan{std::move(name)};
  test::Random random(7);
  const auto number = [&](double low, double most) {
    return low + (most - low) * static_cast<double>(random.between(0, 1 << 20)) / (1 << 20);
  };
  const double h = std::max(wide, deep) * 0.75 + 0.5;
  plan.ground(h + 3);
  for (const double s : {1.0, -1.0}) {
    plan.add({Kind::box, false, {s * (h + 1), 20, 0}, {1, 20, h + 2}});
    plan.add({Kind::box, false, {0, 20, s * (h + 1)}, {h + 2, 20, 1}});
  }
  for (int j = 0; j < high; ++j) {
    for (int i = 0; i < wide; ++i) {
      for (int k = 0; k < deep; ++k) {
        const double x = (i - (wide - 1) / 2.0) * 1.5 + number(-0.1, 0.1);
        const double z = (k - (deep - 1) / 2.0) * 1.5 + number(-0.1, 0.1);
        const auto half =
            kind == Kind::capsule ? Vec<double, 3>{0.3, 0.3, 0} : Vec<double, 3>{0.5, 0.5, 0.5};
        const Vec<double, 3> axis{number(-1, 1), number(-1, 1), number(-1, 1)};
        plan.add({kind, true, {x, 1 + j * 1.5, z}, half, axis, number(-0.2, 0.2)});
      }
    }
  }
  return plan;
}

Plan joint_grid(std::uint32_t side) {
  Plan plan{"joint grid " + std::to_string(side) + "x" + std::to_string(side)};
  for (std::uint32_t i = 0; i < side; ++i) {
    for (std::uint32_t j = 0; j < side; ++j) {
      const bool fixed = (i == 0 || i + 1 == side) && j == 0;
      const double x = i - (side - 1) / 2.0, z = j;
      const auto b = plan.add({Kind::ball, !fixed, {x, 40, z}, {0.4, 0, 0}});
      if (i > 0) plan.links.push_back({b - side, b, {x - 0.5, 40, z}});
      if (j > 0) plan.links.push_back({b - 1, b, {x, 40, z - 0.5}});
    }
  }
  return plan;
}

/// Upright dolls of eleven capsules that fall on each other.
Plan ragdolls(int count) {
  Plan plan{std::to_string(count) + " ragdolls"};
  plan.ground(60);
  for (int n = 0; n < count; ++n) {
    const double x = (n % 5 - 2) * 3.0 / (1 + n / 10), y = 2 + n * 0.15, z = (n / 5 - 1.5) * 1.5;
    const auto limb = [&](double dx, double dy, double half, double r, bool level) {
      return plan.add({Kind::capsule,
                       true,
                       {x + dx, y + dy, z},
                       {r, half, 0},
                       {0, 0, 1},
                       level ? 1.5707963 : 0});
    };
    const auto link = [&](std::uint32_t a, std::uint32_t b, double dx, double dy, bool hinge,
                          Vec<double, 3> axis) {
      plan.links.push_back({a, b, {x + dx, y + dy, z}, hinge, axis});
    };
    const auto pelvis = limb(0, 1.0, 0.10, 0.12, true), chest = limb(0, 1.35, 0.12, 0.14, false);
    const auto head = limb(0, 1.78, 0.05, 0.10, false);
    link(pelvis, chest, 0, 1.14, false, {});
    link(chest, head, 0, 1.64, false, {});
    for (const double s : {-1.0, 1.0}) {
      const auto upper = limb(s * 0.34, 1.48, 0.11, 0.05, true);
      const auto lower = limb(s * 0.64, 1.48, 0.11, 0.045, true);
      const auto thigh = limb(s * 0.12, 0.70, 0.15, 0.07, false);
      const auto shin = limb(s * 0.12, 0.26, 0.15, 0.055, false);
      link(chest, upper, s * 0.18, 1.48, false, {});
      link(pelvis, thigh, s * 0.12, 0.91, false, {});
      link(upper, lower, s * 0.49, 1.48, true, {0, 1, 0});
      link(thigh, shin, s * 0.12, 0.48, true, {1, 0, 0});
    }
  }
  return plan;
}

std::vector<Plan> all_plans() {
  std::vector<Plan> plans{stack(20), pyramid(20), pyramid(50)};
  plans.push_back(heap("heap of 200 boxes", Kind::box, 5, 8, 5));
  plans.push_back(heap("1000 boxes", Kind::box, 10, 10, 10));
  plans.push_back(heap("1000 balls", Kind::ball, 10, 10, 10));
  plans.push_back(heap("1000 capsules", Kind::capsule, 10, 10, 10));
  plans.push_back(heap("1000 hulls", Kind::hull, 10, 10, 10));
  plans.push_back(joint_grid(30));
  plans.push_back(ragdolls(20));
  plans.push_back(heap("10000 boxes", Kind::box, 25, 16, 25));
  Plan asleep{"asleep"};
  asleep.ground(60);
  for (int i = 0; i < 1000; ++i) {
    asleep.add({Kind::box, true, {(i % 32 - 16) * 2.0, 0.5, (i / 32 - 16) * 2.0}, {0.5, 0.5, 0.5}});
  }
  asleep.sleeps = true;
  plans.push_back(asleep);
  return plans;
}

/// Something that steps, and what its steps took.
struct Runner {
  std::string name;
  std::function<void()> step;
  std::function<std::uint64_t()> digest = [] { return std::uint64_t{0}; };
};

template <Scalar S>
struct Stage {
  using Physics = BasicWorld<Growing, S, 3, Sphere<S, 3>, Capsule<S, 3>, Obb<S, 3>, BodyHull<S, 3>,
                             BallJoint<S, 3>, HingeJoint<S, 3>>;
  Physics world;
  std::vector<Vec<S, 3>> points;
  std::optional<SolidHull<S, 3>> solid;

  static Vec<S, 3> vec(const Vec<double, 3>& v) {
    return make_vec<3>([&](int i) { return test::num<S>(v[i]); });
  }

  explicit Stage(const Plan& plan) {
    WorldSettings<S, 3> settings;
    if (!plan.sleeps) settings.sleep_speed = S(0);
    world = Physics(settings);
    for (const auto& p : hull_points()) points.push_back(vec(p));
    solid = solid_hull(1, ConvexHull<S, 3>{points});
    std::vector<BodyId> ids;
    for (const auto& item : plan.items) ids.push_back(add(item));
    for (const auto& link : plan.links) join(link, ids[link.a], ids[link.b]);
  }

  BodyId add(const Item& item) {
    BodyOptions<S, 3> options;
    if (!item.moves) options.motion = BodyMotion::fixed;
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

template <Scalar S>
Runner runner(std::string name, const Plan& plan) {
  const auto stage = std::make_shared<Stage<S>>(plan);
  return {std::move(name), [stage] { stage->world.step(); },
          [stage] { return digest(stage->world); }};
}

#ifdef DETENT_BENCH_BULLET
struct BulletStage {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase pairs;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world{&dispatcher, &pairs, &solver, &configuration};
  std::deque<std::unique_ptr<btCollisionShape>> shapes;
  std::deque<std::unique_ptr<btMotionState>> states;
  std::deque<std::unique_ptr<btRigidBody>> bodies;
  std::deque<std::unique_ptr<btTypedConstraint>> joints;

  static btVector3 vec(const Vec<double, 3>& v) {
    return {static_cast<btScalar>(v.x), static_cast<btScalar>(v.y), static_cast<btScalar>(v.z)};
  }

  explicit BulletStage(const Plan& plan) {
    world.setGravity({0, -10, 0});
    for (const auto& item : plan.items) {
      const auto half = vec(item.half);
      if (item.kind == Kind::box) {
        shapes.push_back(std::make_unique<btBoxShape>(half));
      } else if (item.kind == Kind::ball) {
        shapes.push_back(std::make_unique<btSphereShape>(half.x()));
      } else if (item.kind == Kind::capsule) {
        shapes.push_back(std::make_unique<btCapsuleShape>(half.x(), 2 * half.y()));
      } else {
        auto hull = std::make_unique<btConvexHullShape>();
        for (const auto& p : hull_points()) hull->addPoint(vec(p));
        shapes.push_back(std::move(hull));
      }
      btTransform pose;
      pose.setIdentity();
      pose.setOrigin(vec(item.at));
      pose.setRotation(btQuaternion(vec(item.axis), static_cast<btScalar>(item.angle)));
      states.push_back(std::make_unique<btDefaultMotionState>(pose));
      btVector3 inertia(0, 0, 0);
      const btScalar mass = item.moves ? 1 : 0;
      if (item.moves) shapes.back()->calculateLocalInertia(mass, inertia);
      btRigidBody::btRigidBodyConstructionInfo info(mass, states.back().get(), shapes.back().get(),
                                                    inertia);
      info.m_friction = std::sqrt(btScalar(0.6));  // Bullet multiplies
      bodies.push_back(std::make_unique<btRigidBody>(info));
      if (!plan.sleeps) bodies.back()->setActivationState(DISABLE_DEACTIVATION);
      world.addRigidBody(bodies.back().get());
    }
    for (const auto& link : plan.links) {
      btRigidBody &a = *bodies[link.a], &b = *bodies[link.b];
      const auto in_a = a.getWorldTransform().inverse() * vec(link.at);
      const auto in_b = b.getWorldTransform().inverse() * vec(link.at);
      if (link.is_hinge) {
        const auto axis_a = a.getWorldTransform().getBasis().transpose() * vec(link.axis);
        const auto axis_b = b.getWorldTransform().getBasis().transpose() * vec(link.axis);
        auto hinge = std::make_unique<btHingeConstraint>(a, b, in_a, in_b, axis_a, axis_b);
        hinge->setLimit(btScalar(-1.2), btScalar(1.2));
        joints.push_back(std::move(hinge));
      } else {
        joints.push_back(std::make_unique<btPoint2PointConstraint>(a, b, in_a, in_b));
      }
      world.addConstraint(joints.back().get(), true);
    }
  }
  ~BulletStage() {
    for (auto& joint : joints) world.removeConstraint(joint.get());
    for (auto& body : bodies) world.removeRigidBody(body.get());
  }
};
#endif

double now() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) / 1e6;
}

struct Options {
  std::string only{};
  int steps = 0, passes = 2;
  bool snapshots = false;
  std::vector<std::string> scenes{};
};

std::vector<Runner> runners_of(const Plan& plan, const Options& options) {
  std::vector<Runner> runners;
  const auto wants = [&](std::string_view name) {
    return options.only.empty() || options.only == name;
  };
  if (wants("q16_16")) runners.push_back(runner<q16_16>("q16_16", plan));
  if (wants("float")) runners.push_back(runner<float>("float", plan));
#ifdef DETENT_BENCH_BULLET
  if (wants("bullet")) {
    const auto stage = std::make_shared<BulletStage>(plan);
    runners.push_back({"bullet", [stage] { stage->world.stepSimulation(btScalar(1) / 60, 0); }});
  }
#endif
  return runners;
}

void run(const Plan& plan, const Options& options) {
  const int steps = options.steps > 0 ? options.steps : plan.steps;
  std::vector<std::vector<double>> least;
  std::vector<Runner> runners;
  for (int pass = 0; pass < options.passes; ++pass) {
    runners = runners_of(plan, options);
    least.resize(runners.size(), std::vector<double>(static_cast<std::size_t>(steps), 1e9));
    for (std::size_t i = 0; i < static_cast<std::size_t>(steps); ++i) {
      for (std::size_t r = 0; r < runners.size(); ++r) {
        const double start = now();
        runners[r].step();
        least[r][i] = std::min(least[r][i], now() - start);
      }
    }
  }
  std::printf("%s", plan.name.c_str());
  std::vector<double> times;
  for (const auto& each : least) {
    double sum = 0;
    const int first = std::min(60, steps / 2);
    for (int i = first; i < steps; ++i) sum += each[static_cast<std::size_t>(i)];
    times.push_back(sum / (steps - first));
    std::printf(",%.4f", times.back());
  }
  for (std::size_t r = 1; r < times.size(); ++r) std::printf(",%.2f", times[0] / times[r]);
  std::printf(",%016llx\n", static_cast<unsigned long long>(runners.front().digest()));
  std::fflush(stdout);
}

/// What a rollback pays besides steps: a copy of a world and back, and its snapshot and back.
void time_snapshots(const Plan& plan) {
  Stage<q16_16> stage(plan);
  for (int i = 0; i < 300; ++i) stage.world.step();
  auto saved = stage.world;
  auto bytes = snapshot(stage.world);
  std::span<const SolidHull<q16_16, 3>> hulls;
  if (stage.solid) hulls = {&*stage.solid, 1};
  double copy = 1e9, save = 1e9, load = 1e9;
  for (int i = 0; i < 50; ++i) {
    double start = now();
    saved = stage.world;
    stage.world = saved;
    copy = std::min(copy, now() - start);
    start = now();
    snapshot(stage.world, std::span<std::byte>(bytes));
    save = std::min(save, now() - start);
    start = now();
    if (restore(stage.world, bytes, hulls) != Restored::yes) std::abort();
    load = std::min(load, now() - start);
  }
  std::printf("%s,%zu contacts,%zu bytes,copy and back %.1f us,snapshot %.1f us,restore %.1f us\n",
              plan.name.c_str(), detail::WorldAccess::contacts(stage.world).size(), bytes.size(),
              copy * 1e3, save * 1e3, load * 1e3);
}

}  // namespace
}  // namespace detent::bench

int main(int count, char** arguments) {
  using namespace detent::bench;
  Options options;
  for (int i = 1; i < count; ++i) {
    const std::string argument = arguments[i];
    const bool has_value = i + 1 < count;
    if (argument == "--only" && has_value) {
      options.only = arguments[++i];
    } else if (argument == "--steps" && has_value) {
      options.steps = std::atoi(arguments[++i]);
    } else if (argument == "--passes" && has_value) {
      options.passes = std::atoi(arguments[++i]);
    } else if (argument == "--snapshots") {
      options.snapshots = true;
    } else {
      options.scenes.push_back(argument);
    }
  }
  for (const auto& plan : all_plans()) {
    const auto& wanted = options.scenes;
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), plan.name) == wanted.end())
      continue;
    options.snapshots ? time_snapshots(plan) : run(plan, options);
  }
}
