// SPDX-License-Identifier: MIT
// The forces of joints: exact, in balance with other forces, and those at which joints break.
#include <algorithm>
#include <cmath>
#include <type_traits>
#include <vector>

#include "dynamics/exact.hpp"
#include "dynamics/joint/helpers.hpp"
#include "oracle/space.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

template <Scalar S, int N>
BodyOptions<S, N> of_density(double density) {
  BodyOptions<S, N> options;
  options.density = num<S>(density);
  return options;
}

/// The multiple of 2^-Frac nearest to x; ties go up.
template <int Frac>
Rational nearest(const Rational& x) {
  const Rational scaled = x * (std::int64_t{1} << Frac) + Rational(1, 2);
  auto floor = numerator(scaled) / denominator(scaled);
  if (floor * denominator(scaled) > numerator(scaled)) --floor;
  return Rational(floor) / (std::int64_t{1} << Frac);
}

/// Balls of increasing densities in a row, joined to each other; the first one is fixed.
template <template <Scalar, int> class Joint, Scalar S, int N>
struct Chain {
  explicit Chain(int balls) : world(sleepless<S, N>()) {
    BodyId last = no_object;
    for (int i = 0; i < balls; ++i) {
      auto options = of_density<S, N>(i == 0 ? 1 : 0.25 * i);
      if (i == 0) options.motion = BodyMotion::fixed;
      const Sphere<S, N> ball{at<S, N>(i, 20), num<S>(0.5)};
      const auto next = world.add(ball, options).value_or(no_object);
      if (i != 0) {
        Joint<S, N> joint;
        joint.a = last;
        joint.b = next;
        joint.anchor_a = at<S, N>(0.5, 0);
        joint.anchor_b = at<S, N>(-0.5, 0);
        joints.push_back(world.add(joint).value_or(no_joint));
      }
      last = next;
    }
  }
  [[nodiscard]] const auto& record(const JointId& id) const {
    return detail::WorldAccess::joints(world).list[id.index];
  }
  [[nodiscard]] const auto& body(std::uint32_t index) const {
    return detail::WorldAccess::bodies(world)[index];
  }
  /// Whether x is nearest to the force or torque of a load over the masses of two bodies, clamped.
  [[nodiscard]] bool is_nearest(const S& x, const Rational& load,
                                const detail::BodyPair& pair) const {
    const auto inverse = [&](std::uint32_t index) {
      return body(index).can_move() ? Rational(1 / exact(body(index).mass)) : Rational(0);
    };
    const Rational force = load * (240 * 240) / (inverse(pair.a) + inverse(pair.b));
    const auto expected = std::clamp(force, exact(S::lowest()), exact(S::max()));
    return 2 * abs(exact(x) - expected) <= exact(S::from_raw(1));
  }

  BasicWorld<Growing, S, N, Sphere<S, N>, Joint<S, N>> world;  // g++ 12 rejects World here
  std::vector<JointId> joints;
};

/// A ball on a rod below a fixed one, at rest.
template <Scalar S, int N>
struct Pendulum {
  explicit Pendulum(double density) : world(sleepless<S, N>()) {
    const auto top = add_small_ball<S, N>(world, 0, 0, 0.5, fixed_body<S, N>());
    ball = add_small_ball<S, N>(world, 0, -3, 0.5, of_density<S, N>(density));
    DistanceJoint<S, N> rod;
    rod.a = top;
    rod.b = ball;
    rod.least = rod.most = S(3);
    joint = world.add(rod).value_or(no_joint);
    CHECK(world.joint_force(joint) == Vec<S, N>{});
    for (int t = 0; t < 120; ++t) world.step();
  }

  JointedWorld<S, N> world;
  BodyId ball{};
  JointId joint{};
};

TEMPLATE_TEST_CASE("joint force: carries a weight", "[.all]", DETENT_EVERYDAY_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  Pendulum<S, N> pendulum(2);
  const auto weight = 10 * static_cast<double>(pendulum.world.mass(pendulum.ball));
  const auto force = pendulum.world.joint_force(pendulum.joint);
  const double margin = weight / 1000 + 2.0 / 256;
  for (int k = 0; k < N; ++k) {
    CHECK(std::abs(static_cast<double>(force[k]) - (k == 1 ? weight : 0)) < margin);
  }
  const JointId other{pendulum.joint.index, pendulum.joint.generation + 1};
  CHECK(pendulum.world.joint_force(other) == Vec<S, N>{});
  CHECK(pendulum.world.joint_force(no_joint) == Vec<S, N>{});
}

TEMPLATE_TEST_CASE("joint force: is where a joint breaks", "", (Space<q16_16, 2>),
                   (Space<q16_16, 3>)) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  for (const double share : {0.98, 1.02}) {
    Pendulum<S, N> pendulum(2);
    auto rod = *pendulum.world.template find_joint<DistanceJoint<S, N>>(pendulum.joint);
    rod.break_force =
        num<S>(share * static_cast<double>(length(pendulum.world.joint_force(pendulum.joint))));
    REQUIRE(pendulum.world.change(pendulum.joint, rod));
    pendulum.world.step();
    CHECK(pendulum.world.contains(pendulum.joint) == (share > 1));
  }
}

TEMPLATE_TEST_CASE("joint force: of every kind, two bodies are pulled apart and stay together", "",
                   (DistanceJoint<q16_16, 2>), (BallJoint<q16_16, 2>), (HingeJoint<q16_16, 2>),
                   (WeldJoint<q16_16, 2>)) {
  using S = q16_16;
  WorldSettings<S, 2> settings = sleepless<S, 2>();
  settings.gravity = {};
  JointedWorld<S, 2> world(settings);
  const auto left = add_box<S, 2>(world, -1, 0, 0.5, 0.5, of_density<S, 2>(3));
  const auto right = add_box<S, 2>(world, 1, 0, 0.5, 0.5);
  auto joint = joint_at<TestType>(world, left, right, 0, 0);
  if constexpr (std::is_same_v<TestType, DistanceJoint<S, 2>>) {
    joint.anchor_a = joint.anchor_b = {};
    joint.least = joint.most = S(2);
  }
  const auto id = world.add(joint).value_or(no_joint);
  for (int t = 0; t < 60; ++t) {
    world.apply_force(left, at<S, 2>(-40, 0));
    world.apply_force(right, at<S, 2>(40, 0));
    world.step();
  }
  const auto force = world.joint_force(id);
  CHECK(std::abs(static_cast<double>(force.x) + 40) < 0.1);  // b is held back
  CHECK(std::abs(static_cast<double>(force.y)) < 0.1);
}

TEMPLATE_TEST_CASE("joint force: each component is the exact one, rounded once and clamped", "",
                   (Space<q16_16, 3>), (Space<q8_8, 3>)) {
  using S = typename TestType::scalar;
  // Ball joints push along the axes of the world, so their impulses are the loads.
  Chain<BallJoint, S, 3> chain(8);
  for (int t = 0; t < 90; ++t) {
    chain.world.step();
    for (const auto& id : chain.joints) {
      const auto& record = chain.record(id);
      const auto force = chain.world.joint_force(id);
      for (int k = 0; k < 3; ++k) {
        const auto load = exact(record.push[static_cast<std::size_t>(k)]);
        CHECK(chain.is_nearest(force[k], load, record.bodies()));
      }
    }
  }
}

// A box on a wall: its joint carries its weight at a lever of 2, about the z axis. A smaller box
// would be beyond the range of q8_8.
TEMPLATE_TEST_CASE("joint torque: carries a weight at a lever", "[.all]", DETENT_EVERYDAY_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto check = []<class Joint>(Joint, const auto& change) {
    JointedWorld<S, N> world(sleepless<S, N>());
    const auto wall = add_box<S, N>(world, -1, 0, 1, 1, fixed_body<S, N>());
    const auto box = add_box<S, N>(world, 2, 0, 2, 2, of_density<S, N>(1.0 / 32));
    auto joint = joint_at<Joint>(world, wall, box, 0, 0);
    change(joint);
    const auto id = world.add(joint).value_or(no_joint);
    CHECK(world.joint_torque(id) == detail::Axial<S, N>{});
    for (int t = 0; t < 60; ++t) world.step();
    const auto torque = world.joint_torque(id);
    const auto moment = 2 * 10 * static_cast<double>(world.mass(box));
    const std::size_t z = torque.size() - 1;
    CAPTURE(static_cast<double>(torque[z]), moment);
    CHECK(std::abs(static_cast<double>(torque[z]) - moment) < moment / 50 + 2.0 / 256);
    for (std::size_t k = 0; k < z; ++k) {
      CHECK(std::abs(static_cast<double>(torque[k])) < moment / 50 + 2.0 / 256);
    }
    CHECK(world.joint_torque(no_joint) == detail::Axial<S, N>{});
  };
  check(WeldJoint<S, N>(), [](auto&) {});
  check(HingeJoint<S, N>(), [](auto& brake) { brake.motor_torque = S(100); });
  check(HingeJoint<S, N>(), [](auto& at_its_end) { at_its_end.has_limits = true; });
  // A ball joint cannot carry it.
  JointedWorld<S, N> world(sleepless<S, N>());
  const auto wall = add_box<S, N>(world, -1, 0, 1, 1, fixed_body<S, N>());
  const auto box = add_box<S, N>(world, 1, 0, 0.5, 0.5);
  const auto id = world.add(joint_at<BallJoint<S, N>>(world, wall, box, 0, 0)).value_or(no_joint);
  world.step();
  CHECK(world.joint_torque(id) == detail::Axial<S, N>{});
}

TEMPLATE_TEST_CASE("joint torque: of a motor that is not yet up to speed is its greatest", "",
                   (Space<q16_16, 2>), (Space<q16_16, 3>)) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  WorldSettings<S, N> settings = sleepless<S, N>();
  settings.gravity = {};
  JointedWorld<S, N> world(settings);
  const auto a = add_box<S, N>(world, 0, 0, 1, 0.25, of_density<S, N>(3));
  const auto b = add_box<S, N>(world, 0, 0, 0.5, 0.5);
  auto motor = joint_at<HingeJoint<S, N>>(world, a, b, 0, 0);
  motor.motor_speed = S(200);
  motor.motor_torque = num<S>(1.5);
  const auto id = world.add(motor).value_or(no_joint);
  for (int t = 0; t < 10; ++t) world.step();
  const auto torque = world.joint_torque(id);
  CHECK(std::abs(static_cast<double>(torque[torque.size() - 1]) - 1.5) < 0.001);
}

TEMPLATE_TEST_CASE("joint torque: each component is the exact one, rounded where the document says",
                   "", (Space<q16_16, 2>), (Space<q16_16, 3>), (Space<q8_8, 3>)) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  using F = detail::Formats<S>;
  // Welds turn about the axes of the world, and the inertia of a ball is the same about all.
  Chain<WeldJoint, S, N> chain(5);
  bool any = false;
  for (int t = 0; t < 60; ++t) {
    chain.world.step();
    for (const auto& id : chain.joints) {
      const auto& record = chain.record(id);
      const auto &a = chain.body(record.bodies().a), &b = chain.body(record.bodies().b);
      const auto [share_a, share_b] = detail::mass_shares<S>(a, b);
      const auto torque = chain.world.joint_torque(id);
      for (std::size_t k = 0; k < torque.size(); ++k) {
        const auto gyration = [&](const auto& body, const auto& share) {
          if (!body.can_move()) return Rational(0);
          const auto spread = detail::support_of<S, N>(body).spread;
          return exact(nearest_to<typename F::Gyration>(spread[k] * share));
        };
        const Rational s = gyration(a, share_a) + gyration(b, share_b);
        const auto load = nearest<F::Torque::frac>(Rational(exact(record.turn[k]) / s));
        CHECK(chain.is_nearest(torque[k], load, record.bodies()));
        any = any || torque[k] != S{};
      }
    }
  }
  CHECK(any);
}

}  // namespace
}  // namespace detent::test
