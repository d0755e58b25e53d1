// SPDX-License-Identifier: MIT
//
// Joints and bodies with solid hulls: the C interface gives the bits of C++.

#include <array>
#include <cstdint>
#include <vector>

#include "world_twins.hpp"

namespace detent::test_c {
namespace {

/// A world in C and in C++ in which bodies hang on a beam and on each other.
template <int N>
struct Twins : WorldTwins<N> {
  using C = Calls<N>;
  using T = c::Types<N>;
  using Out = c::Output<N>;
  using WorldTwins<N>::context, WorldTwins<N>::world, WorldTwins<N>::twin;

  detent_handle solid = 0;
  std::vector<Vec<S, N>> points;
  std::array<SolidHull<S, N>, 1> hulls{};
  std::vector<detent_id> bodies, joints;
  int turned = 0;  // joints with a torque, after any step

  Twins() {
    std::vector<typename T::Vec> raw_points;
    for (int k = 0; k <= N; ++k) {
      points.push_back(make_vec<N>([&](int i) { return i + 1 == k ? S(1) : S(0); }));
      raw_points.push_back(Out::vec(points.back()));
    }
    const auto size = static_cast<std::uint32_t>(points.size());
    REQUIRE(C::solid_create(&context, 5, raw_points.data(), 2, &solid) == DETENT_BAD_ARGUMENT);
    REQUIRE(C::solid_create(&context, 5, raw_points.data(), size, &solid) == DETENT_OK);
    hulls[0] = *solid_hull(5, ConvexHull<S, N>{points});
    add_hull(place(-1), BodyMotion::fixed);
    for (int i = 0; i < 7; ++i) add_hull(place(i), BodyMotion::dynamic);
  }

  static Vec<S, N> place(int i) {
    return make_vec<N>([&](int axis) { return axis == 0 ? S(2 * i) : axis == 1 ? S(6) : S(0); });
  }
  void add_hull(const Vec<S, N>& at, BodyMotion motion) {
    BodyOptions<S, N> own;
    own.motion = motion;
    bodies.push_back(
        this->add(this->placed(DETENT_HULL, solid, at), BodyHull<S, N>{&hulls[0], at, {}}, own));
  }

  /// Adds a joint of kind `kind` between bodies i and i + 1 to both, with its own numbers.
  template <class F>
  void with_joint(std::uint32_t kind, std::size_t i, test::Random& random, const F& f) {
    typename T::Joint given{};
    REQUIRE(C::joint_defaults(kind, &given) == DETENT_OK);
    const auto some = [&](int most) {
      return static_cast<std::int32_t>(random.below(static_cast<std::uint64_t>(most)));
    };
    given.a = bodies[i];
    given.b = bodies[i + 1];
    given.anchor_a.x = one;
    given.anchor_b.x = -one;
    given.collide = random.one_in(3) ? 1 : 0;
    given.break_force = random.one_in(4) ? 1 + some(20 * one) : 0;
    given.has_limits = random.one_in(2) ? 1 : 0;
    given.lower = -some(one / 2);
    given.upper = some(one / 2);
    given.motor_speed = some(2 * one) - one;
    given.motor_force = random.one_in(2) ? some(40 * one) : 0;
    given.length = some(one);
    given.frequency = random.one_in(2) ? some(4 * one) : 0;
    given.damping_ratio = some(2 * one);
    if (random.one_in(2)) given.cone_angle = some(one);
    const auto fill = [&](auto joint) {
      joint.a = id_of(given.a);
      joint.b = id_of(given.b);
      joint.anchor_a = c::Input<N>::vec(given.anchor_a);
      joint.anchor_b = c::Input<N>::vec(given.anchor_b);
      joint.collide = given.collide == 1;
      joint.break_force = raw(given.break_force);
      f(given, joint);
    };
    const auto limit = [&](auto& joint) {
      joint.has_limits = given.has_limits == 1;
      joint.lower = raw(given.lower);
      joint.upper = raw(given.upper);
      if constexpr (requires { joint.motor_speed; }) joint.motor_speed = raw(given.motor_speed);
    };
    const auto spring = [&](auto& joint) {
      joint.frequency = raw(given.frequency);
      joint.damping_ratio = raw(given.damping_ratio);
    };
    switch (kind) {
      case DETENT_DISTANCE_JOINT: {
        DistanceJoint<S, N> joint;
        joint.least = raw(given.lower);
        joint.most = raw(given.upper);
        joint.length = raw(given.length);
        spring(joint);
        return fill(joint);
      }
      case DETENT_BALL_JOINT: {
        BallJoint<S, N> joint;
        joint.max_force = raw(given.motor_force);
        spring(joint);
        return fill(joint);
      }
      case DETENT_HINGE_JOINT: {
        HingeJoint<S, N> joint;
        limit(joint);
        spring(joint);
        joint.angle = raw(given.length);
        joint.motor_torque = raw(given.motor_force);
        return fill(joint);
      }
      case DETENT_WELD_JOINT: {
        WeldJoint<S, N> joint;
        spring(joint);
        return fill(joint);
      }
      case DETENT_SLIDER_JOINT: {
        SliderJoint<S, N> joint;
        limit(joint);
        spring(joint);
        joint.length = raw(given.length);
        joint.motor_force = raw(given.motor_force);
        return fill(joint);
      }
      case DETENT_CONE_JOINT:
        if constexpr (N == 3) {
          ConeJoint<S, N> joint;
          limit(joint);
          joint.cone_angle = raw(given.cone_angle);
          return fill(joint);
        }
        return;
      default: {
        WheelJoint<S, N> joint;
        limit(joint);
        spring(joint);
        joint.length = raw(given.length);
        joint.motor_torque = raw(given.motor_force);
        return fill(joint);
      }
    }
  }

  /// Steps both and compares the broken joints, and the forces and torques of the others.
  std::uint32_t step() {
    WorldTwins<N>::step();
    std::array<detent_id, 8> broken{};
    std::uint32_t count = 0;
    REQUIRE(C::world_broken(&context, world, broken.data(), 8, &count) == DETENT_OK);
    REQUIRE(count == twin.broken_count());
    for (std::size_t i = 0; i < count; ++i) {
      REQUIRE(broken[i].index == twin.broken(i).index);
      REQUIRE(broken[i].generation == twin.broken(i).generation);
    }
    REQUIRE(C::world_joint_count(&context, world, &count) == DETENT_OK);
    REQUIRE(count == twin.joint_count());
    for (const auto& id : joints) {
      typename c::Types<N>::Vec force{};
      const JointId same{id.index, id.generation};
      const auto status = C::world_joint_force(&context, world, id, &force);
      REQUIRE(status == c::yes_or_no(twin.contains(same)));
      if (status == DETENT_OK) REQUIRE(c::Input<N>::vec(force) == twin.joint_force(same));
      std::array<std::int32_t, 4> torque{};
      REQUIRE(C::world_joint_torque(&context, world, id, torque.data()) == status);
      const auto own = twin.joint_torque(same);
      for (std::size_t i = 0; i < own.size(); ++i) REQUIRE(torque[i] == own[i].raw());
      REQUIRE(torque[own.size()] == 0);
      turned += torque[0] != 0 ? 1 : 0;
    }
    return static_cast<std::uint32_t>(twin.broken_count());
  }
};

template <int N>
void check_joints() {
  using C = Calls<N>;
  constexpr std::uint32_t last_joint = N == 2 ? DETENT_WHEEL_JOINT : DETENT_CONE_JOINT;
  test::Random random(50 + N);
  std::uint32_t broken = 0;
  for (int round = 0; round < 8; ++round) {
    CAPTURE(N, round);
    Twins<N> twins;
    auto& context = twins.context;
    const auto world = twins.world;
    for (std::uint32_t kind = 1; kind <= last_joint; ++kind) {
      twins.with_joint(kind, kind - 1, random, [&](const auto& given, const auto& joint) {
        detent_id id{};
        REQUIRE(C::world_add_joint(&context, world, &given, &id) == DETENT_OK);
        const auto same = twins.twin.add(joint);
        REQUIRE(same);
        REQUIRE((same->index == id.index && same->generation == id.generation));
        typename c::Types<N>::Joint read{};
        REQUIRE(C::world_joint(&context, world, id, &read) == DETENT_OK);
        CHECK(read.kind == kind);
        CHECK(read.b.index == given.b.index);
        CHECK(read.break_force == given.break_force);
        twins.joints.push_back(id);
      });
    }
    for (int tick = 0; tick < 20; ++tick) broken += twins.step();
    // Changes the numbers of each remaining joint.
    for (std::uint32_t kind = 1; kind <= last_joint; ++kind) {
      twins.with_joint(kind, kind - 1, random, [&](const auto& given, const auto& joint) {
        const auto id = twins.joints[kind - 1];
        const JointId same{id.index, id.generation};
        REQUIRE(C::world_change_joint(&context, world, id, &given) ==
                c::yes_or_no(twins.twin.change(same, joint)));
        if (kind != 3) return;
        REQUIRE(C::world_remove_joint(&context, world, id) ==
                c::yes_or_no(twins.twin.remove(same)));
        REQUIRE(C::world_remove_joint(&context, world, id) == DETENT_NO);
        REQUIRE(C::world_joint(&context, world, id, nullptr) == DETENT_BAD_ARGUMENT);
        REQUIRE(C::world_joint_force(&context, world, id, nullptr) == DETENT_BAD_ARGUMENT);
        REQUIRE(C::world_joint_torque(&context, world, id, nullptr) == DETENT_BAD_ARGUMENT);
      });
    }
    for (int tick = 0; tick < 10; ++tick) broken += twins.step();
    CHECK(twins.turned > 0);
    const auto saved = twins.saved();
    CHECK((saved == snapshot(twins.twin)));
    twins.step();
    REQUIRE(twins.restore(saved) == DETENT_OK);
    REQUIRE(restore(twins.twin, saved, twins.hulls) == Restored::yes);
    twins.step();
    typename c::Types<N>::Vec point{}, local{};
    point.x = one;
    point.y = 2 * one;
    REQUIRE(C::world_local_point(&context, world, twins.bodies[2], &point, &local) == DETENT_OK);
    CHECK(c::Input<N>::vec(local) ==
          twins.twin.local_point(id_of(twins.bodies[2]), c::Input<N>::vec(point)));
    const auto axes = c::Output<N>::rotation(Rotation<S, N>());
    typename c::Types<N>::Rotation turned{};
    REQUIRE(C::world_local_frame(&context, world, twins.bodies[2], &axes, &turned) == DETENT_OK);
    CHECK(c::Input<N>().rotation(turned) ==
          twins.twin.local_frame(id_of(twins.bodies[2]), Rotation<S, N>()));
    CHECK(detent_asset_destroy(&context, twins.solid) == DETENT_IN_USE);
  }
  CHECK(broken > 0);
}

TEST_CASE("C joints: every kind gives the bits of C++, in 2D") { check_joints<2>(); }
TEST_CASE("C joints: every kind gives the bits of C++, in 3D") { check_joints<3>(); }

TEST_CASE("C joints: wrong numbers, kinds and bodies are errors") {
  Twins<2> twins;
  detent_joint2 joint{};
  detent_id id{};
  CHECK(detent_joint2_defaults(0, &joint) == DETENT_BAD_ARGUMENT);
  CHECK(detent_joint2_defaults(DETENT_CONE_JOINT, &joint) == DETENT_BAD_ARGUMENT);
  detent_joint3 cone{};
  CHECK(detent_joint3_defaults(DETENT_CONE_JOINT, &cone) == DETENT_OK);
  CHECK(detent_joint3_defaults(DETENT_CONE_JOINT + 1, &cone) == DETENT_BAD_ARGUMENT);
  REQUIRE(detent_joint2_defaults(DETENT_HINGE_JOINT, &joint) == DETENT_OK);
  const auto add = [&](const detent_joint2& given) {
    return detent_world2_add_joint(&twins.context, twins.world, &given, &id);
  };
  CHECK(add(joint) == DETENT_NO);
  joint.a = joint.b = twins.bodies[0];
  CHECK(add(joint) == DETENT_NO);
  joint.b = twins.bodies[1];
  CHECK(add(joint) == DETENT_OK);
  for (auto field :
       {&detent_joint2::break_force, &detent_joint2::motor_force, &detent_joint2::frequency,
        &detent_joint2::damping_ratio, &detent_joint2::cone_angle}) {
    auto wrong = joint;
    wrong.*field = -1;
    CHECK(add(wrong) == DETENT_BAD_ARGUMENT);
  }
  auto wrong = joint;
  wrong.collide = 2;
  CHECK(add(wrong) == DETENT_BAD_ARGUMENT);
  wrong = joint;
  wrong.frame_b.axis[1] = {};
  CHECK(add(wrong) == DETENT_NOT_UNIT);
  wrong = joint;
  wrong.kind = DETENT_WELD_JOINT;
  CHECK(detent_world2_change_joint(&twins.context, twins.world, id, &wrong) == DETENT_NO);
}

}  // namespace
}  // namespace detent::test_c
