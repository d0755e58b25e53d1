// SPDX-License-Identifier: MIT
//
// usage: detent-bench-worlds [--only q16_16|float|bullet] [--steps N] [--passes N]
//                            [--snapshots | --threads N | --growth] [SCENE...]
// Steps scenes of bodies in q16_16, in float and in Bullet, alternating step by step, and prints a
// table as CSV: milliseconds per step, the mean of steps 60 to 299 of the fastest pass. Sleeping is
// off, except in the scene "asleep". --only runs one of them, for example in a profiler. The last
// column is the digest of q16_16, which an optimisation must not change. --threads compares one
// thread with N in wall-clock time. --growth alternates between the scenes instead of the engines, and
// prints their times as multiples of the first one's.

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

#include "bench/worlds/stage.hpp"
#include "detent/dynamics/snapshot.hpp"
#include "support/pool.hpp"

#ifdef DETENT_BENCH_BULLET
#include <btBulletDynamicsCommon.h>
#endif

namespace detent::bench {
namespace {

/// An engine that steps, and the times of its steps.
struct Runner {
  std::string name;
  std::function<void()> step;
  std::function<std::uint64_t()> digest = [] { return std::uint64_t{0}; };
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
        for (const auto& p : plan.hull) hull->addPoint(vec(p));
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
      info.m_friction = std::sqrt(btScalar(0.6));  // Bullet multiplies friction
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

double now(clockid_t clock = CLOCK_THREAD_CPUTIME_ID) {
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) / 1e6;
}

struct Options {
  std::string only{};
  int steps = 0, passes = 2;
  bool snapshots = false, growth = false;
  std::size_t threads = 0;
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

/// Milliseconds per step of each runner, alternating: the mean of steps from 60 on, each the least of
/// the passes. `start` makes the runners, which keep their last state.
template <class Start>
std::vector<double> alternate(std::vector<Runner>& runners, int steps, int passes,
                              const Start& start) {
  std::vector<std::vector<double>> least;
  for (int pass = 0; pass < passes; ++pass) {
    runners = start();
    least.resize(runners.size(), std::vector<double>(static_cast<std::size_t>(steps), 1e9));
    for (std::size_t i = 0; i < static_cast<std::size_t>(steps); ++i) {
      for (std::size_t r = 0; r < runners.size(); ++r) {
        const double begin = now();
        runners[r].step();
        least[r][i] = std::min(least[r][i], now() - begin);
      }
    }
  }
  std::vector<double> times;
  for (const auto& each : least) {
    double sum = 0;
    const int first = std::min(60, steps / 2);
    for (int i = first; i < steps; ++i) sum += each[static_cast<std::size_t>(i)];
    times.push_back(sum / (steps - first));
  }
  return times;
}

void run(const Plan& plan, const Options& options) {
  const int steps = options.steps > 0 ? options.steps : plan.steps;
  std::vector<Runner> runners;
  const auto times =
      alternate(runners, steps, options.passes, [&] { return runners_of(plan, options); });
  std::printf("%s", plan.name.c_str());
  for (const double time : times) std::printf(",%.4f", time);
  for (std::size_t r = 1; r < times.size(); ++r) std::printf(",%.2f", times[0] / times[r]);
  std::printf(",%016llx\n", static_cast<unsigned long long>(runners.front().digest()));
  std::fflush(stdout);
}

/// How times grow with scenes, in each engine.
void compare_scenes(const std::vector<Plan>& plans, const Options& options) {
  const int steps = options.steps > 0 ? options.steps : plans.front().steps;
  for (const auto& engine : runners_of(plans.front(), options)) {
    Options only = options;
    only.only = engine.name;
    std::vector<Runner> runners;
    const auto times = alternate(runners, steps, options.passes, [&] {
      std::vector<Runner> all;
      for (const auto& plan : plans) all.push_back(runners_of(plan, only).front());
      return all;
    });
    std::printf("%s", engine.name.c_str());
    for (std::size_t i = 0; i < times.size(); ++i) {
      std::printf(",%s,%.4f,%.2f", plans[i].name.c_str(), times[i], times[i] / times[0]);
    }
    std::printf("\n");
    std::fflush(stdout);
  }
}

/// The costs of a rollback besides steps: copying a world and back, and its snapshot and back.
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

/// Milliseconds per step on one thread and on several, alternating: the mean of the second half of
/// all steps, each the least of the passes.
void time_threads(const Plan& plan, const Options& options) {
  test::Pool pool(options.threads);
  const auto steps = static_cast<std::size_t>(options.steps > 0 ? options.steps : plan.steps);
  std::vector<double> one(steps, 1e9), many(steps, 1e9);
  for (int pass = 0; pass < options.passes; ++pass) {
    Stage<q16_16> alone(plan), together(plan);
    for (std::size_t i = 0; i < steps; ++i) {
      double start = now(CLOCK_MONOTONIC);
      alone.world.step();
      one[i] = std::min(one[i], now(CLOCK_MONOTONIC) - start);
      start = now(CLOCK_MONOTONIC);
      together.world.step(pool);
      many[i] = std::min(many[i], now(CLOCK_MONOTONIC) - start);
      if (digest(alone.world) != digest(together.world)) std::abort();
    }
  }
  const auto mean = [&](const std::vector<double>& times) {
    double sum = 0;
    for (std::size_t i = steps / 2; i < steps; ++i) sum += times[i];
    return sum / static_cast<double>(steps - steps / 2);
  };
  const double a = mean(one), b = mean(many);
  std::printf("%s,%.4f,%.4f,%.2f\n", plan.name.c_str(), a, b, a / b);
  std::fflush(stdout);
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
    } else if (argument == "--threads" && has_value) {
      options.threads = static_cast<std::size_t>(std::atoi(arguments[++i]));
    } else if (argument == "--growth") {
      options.growth = true;
    } else {
      options.scenes.push_back(argument);
    }
  }
  auto plans = all_plans();
  std::erase_if(plans, [&](const Plan& plan) {
    const auto& wanted = options.scenes;
    return !wanted.empty() && std::find(wanted.begin(), wanted.end(), plan.name) == wanted.end();
  });
  if (options.growth && !plans.empty()) {
    compare_scenes(plans, options);
    return 0;
  }
  for (const auto& plan : plans) {
    if (options.threads != 0) {
      time_threads(plan, options);
    } else {
      options.snapshots ? time_snapshots(plan) : run(plan, options);
    }
  }
}
