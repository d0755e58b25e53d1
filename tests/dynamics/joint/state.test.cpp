// SPDX-License-Identifier: MIT
// Joints are part of the state: snapshots, digests, differences, and independence of history.
#include <span>
#include <string>

#include "detent/scene/difference.hpp"
#include "dynamics/joint/helpers.hpp"
#include "dynamics/step_alike.hpp"
#include "oracle/space.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"
#include "support/seal.hpp"

namespace detent::test {
namespace {

using S = q16_16;
using Bytes = std::vector<std::byte>;

constexpr std::uint32_t body_count = 14;
constexpr std::uint32_t joint_total = 12;

/// Body i of the scene: 0 is the ground, 1 hangs in the air.
template <int N>
void put_body(JointedWorld<S, N>& world, std::uint32_t i) {
  BodyOptions<S, N> options;
  if (i < 2) options.motion = BodyMotion::fixed;
  options.density = num<S>(1 + i % 3);
  const BodyId id{i, 1 + i % 2};
  if (i == 0) {
    Obb<S, N> ground{at<S, N>(0, -1), at<S, N>(40, 1), {}};
    if constexpr (N == 3) ground.half_extents.z = S(40);
    REQUIRE(world.put(id, ground, options));
  } else if (i % 3 == 0) {
    REQUIRE(world.put(id, Sphere<S, N>{at<S, N>(1.1 * i - 6, 2 + 0.2 * (i % 4)), num<S>(0.4)},
                      options));
  } else {
    Obb<S, N> box{at<S, N>(1.1 * i - 6, 2 + 0.2 * (i % 4)), at<S, N>(0.5, 0.3), {}};
    if constexpr (N == 3) box.half_extents.z = num<S>(0.25);
    REQUIRE(world.put(id, box, options));
  }
}

template <class Joint, int N>
void put_as(JointedWorld<S, N>& world, std::uint32_t i, Joint joint) {
  const std::uint32_t a = 1 + i, b = 2 + i;
  joint.a = {a, 1 + a % 2};
  joint.b = {b, 1 + b % 2};
  joint.anchor_a = at<S, N>(0.5, 0.1);
  joint.anchor_b = at<S, N>(-0.6, 0);
  joint.collide = i % 4 == 1;
  REQUIRE(world.put(JointId{i, 1 + i % 3}, joint));
}

/// Joint i connects bodies i + 1 and i + 2; every kind occurs twice.
template <int N>
void put_joint(JointedWorld<S, N>& world, std::uint32_t i) {
  switch (i % 6) {
    case 0: {
      DistanceJoint<S, N> joint;
      joint.least = num<S>(0.2);
      joint.frequency = S(2);
      put_as(world, i, joint);
      break;
    }
    case 1: {
      BallJoint<S, N> joint;
      joint.break_force = S(i == 7 ? 1 : 0);
      joint.frequency = S(i == 7 ? 3 : 0);
      put_as(world, i, joint);
      break;
    }
    case 2: {
      HingeJoint<S, N> joint;
      joint.has_limits = true;
      joint.lower = num<S>(-0.5);
      joint.upper = num<S>(0.7);
      joint.motor_speed = S(2);
      joint.motor_torque = S(3);
      put_as(world, i, joint);
      break;
    }
    case 3:
      put_as(world, i, WeldJoint<S, N>());
      break;
    case 4: {
      SliderJoint<S, N> joint;
      joint.has_limits = true;
      joint.lower = num<S>(-0.1);
      joint.upper = num<S>(0.4);
      joint.motor_speed = S(-1);
      joint.motor_force = S(4);
      put_as(world, i, joint);
      break;
    }
    default: {
      WheelJoint<S, N> joint;
      joint.frequency = S(3);
      joint.motor_speed = S(5);
      joint.motor_torque = S(1);
      put_as(world, i, joint);
      break;
    }
  }
}

template <int N>
JointedWorld<S, N> scene() {
  JointedWorld<S, N> world;
  for (std::uint32_t i = 0; i < body_count; ++i) put_body(world, i);
  for (std::uint32_t i = 0; i < joint_total; ++i) put_joint(world, i);
  return world;
}

using Limbs = World<S, 3, Sphere, Obb, BallJoint, ConeJoint>;

constexpr std::uint32_t limb_count = 7;

/// Link i of a chain that hangs from link 0.
template <class World>
void put_limb(World& world, std::uint32_t i) {
  BodyOptions<S, 3> options;
  if (i == 0) options.motion = BodyMotion::fixed;
  if (i == 4) options.angular_velocity = {S(20), S(-3), S(5)};
  options.density = num<S>(1 + i % 3);
  const Obb<S, 3> box{at<S, 3>(i, 6), {num<S>(0.4), num<S>(0.2), num<S>(0.1 + 0.05 * i)}, {}};
  REQUIRE(world.put(BodyId{i, 1 + i % 2}, box, options));
}
/// Joint i connects links i and i + 1, with axis 2 along the chain.
void put_cone(Limbs& world, std::uint32_t i) {
  ConeJoint<S, 3> joint;
  joint.a = {i, 1 + i % 2};
  joint.b = {i + 1, 1 + (i + 1) % 2};
  joint.anchor_a = at<S, 3>(0.5, 0);
  joint.anchor_b = at<S, 3>(-0.5, 0);
  joint.frame_a = joint.frame_b =
      Rotation<S, 3>::from_axis_angle(Direction<S, 3>::along(1), Angle<S>::turn(1, 4));
  joint.cone_angle = num<S>(i % 3 == 2 ? 0 : 0.2 + 0.1 * i);
  joint.has_limits = i % 2 == 0;
  joint.lower = num<S>(-0.3);
  joint.upper = num<S>(0.1 * i);
  joint.break_force = S(i == 5 ? 20 : 0);
  REQUIRE(world.put(JointId{i, 1 + i % 3}, joint));
}
Limbs limbs() {
  Limbs world;
  for (std::uint32_t i = 0; i < limb_count; ++i) put_limb(world, i);
  for (std::uint32_t i = 0; i + 1 < limb_count; ++i) put_cone(world, i);
  return world;
}

template <class F>
void in_both_dimensions(const F& f) {
  f(std::integral_constant<int, 2>());
  f(std::integral_constant<int, 3>());
}

}  // namespace

TEST_CASE("joint: a restored world continues bit for bit") {
  in_both_dimensions([](auto dimension) {
    constexpr int N = decltype(dimension)::value;
    auto world = scene<N>();
    for (int t = 0; t < 150; ++t) {
      if (t % 30 == 4) {
        JointedWorld<S, N> fresh;
        put_body(fresh, 0);
        put_body(fresh, 1);
        const auto bytes = snapshot(world);
        REQUIRE(restore(fresh, bytes) == Restored::yes);
        REQUIRE(snapshot(fresh) == bytes);
        CHECK(fresh.joint_count() == world.joint_count());
        auto copy = world;
        step_alike(copy, fresh, 60);
      }
      world.step();
    }
    CHECK(world.joint_count() == joint_total - 1);  // one broke
    CHECK(!world.contains(JointId{7, 2}));
  });
}

TEST_CASE("joint: a scene with every kind has its golden digest") {
  const auto after = [](auto world) {
    for (int t = 0; t < 150; ++t) world.step();
    return digest(world);
  };
  CHECK(after(scene<2>()) == 0xba5a9babb236777fu);
  CHECK(after(scene<3>()) == 0x2159a80286abb311u);
}

TEST_CASE("joint: a restored chain of cones continues bit for bit, to its golden digest") {
  auto world = limbs();
  for (int t = 0; t < 150; ++t) {
    if (t % 40 == 4) {
      Limbs fresh;
      put_limb(fresh, 0);
      const auto bytes = snapshot(world);
      REQUIRE(restore(fresh, bytes) == Restored::yes);
      REQUIRE(snapshot(fresh) == bytes);
      world = fresh;
    }
    world.step();
  }
  CHECK(!world.contains(JointId{5, 3}));  // it broke
  CHECK(world.joint_count() == limb_count - 2);
  CHECK(digest(world) == 0xb2a94a6afa7894d6u);
}

TEST_CASE("joint: bits of cones do not depend on the order of additions and removals") {
  auto forward = limbs();
  Limbs backward, changed;
  for (std::uint32_t i = limb_count; i-- > 0;) put_limb(backward, i);
  for (std::uint32_t i = limb_count - 1; i-- > 0;) put_cone(backward, i);
  for (std::uint32_t i = 0; i < limb_count; ++i) put_limb(changed, i);
  for (std::uint32_t i = 0; i + 1 < limb_count; i += 2) put_cone(changed, i);
  REQUIRE(changed.remove(BodyId{3, 2}));  // removes joint 2 with it
  put_limb(changed, 3);
  for (std::uint32_t i = limb_count - 1; i-- > 0;) {
    if (!changed.contains(JointId{i, 1 + i % 3})) put_cone(changed, i);
  }
  for (int t = 0; t < 150; ++t) {
    REQUIRE(digest(forward) == digest(backward));
    REQUIRE(digest(forward) == digest(changed));
    for (auto* world : {&forward, &backward, &changed}) world->step();
  }
}

TEST_CASE("joint: diff names the fields of a cone, and its impulses are part of the state") {
  auto world = limbs();
  for (int t = 0; t < 60; ++t) world.step();
  auto other = world;
  auto& joint = detail::WorldAccess::joints(other).list[1];
  const auto good = joint;
  REQUIRE(good.turn[0] != 0);
  const auto differs = [&](const auto& change) {
    auto changed = *other.find_joint<ConeJoint<S, 3>>({1, 2});
    change(changed);
    joint.joint = decltype(joint.joint)(changed);
    CHECK(digest(world) != digest(other));
    const auto first = diff(world, other);
    REQUIRE(first);
    const std::string name(first->field.view());
    joint = good;
    return name;
  };
  CHECK(differs([](auto& cone) { cone.cone_angle = S(2); }) == "joint 1:2 cone_angle");
  CHECK(differs([](auto& cone) { cone.has_limits = true; }) == "joint 1:2 has_limits");
  CHECK(differs([](auto& cone) { cone.lower = S(2); }) == "joint 1:2 lower");
  CHECK(differs([](auto& cone) { cone.upper = S(2); }) == "joint 1:2 upper");
  CHECK(!diff(world, other));
  joint.turn = {};
  CHECK(std::string(diff(world, other)->field.view()).starts_with("joint 1:2 turn"));
}

TEST_CASE("joint: springs of hinges and welds are part of the state, and of snapshots if set") {
  in_both_dimensions([](auto dimension) {
    constexpr int N = decltype(dimension)::value;
    auto world = scene<N>();
    for (int t = 0; t < 10; ++t) world.step();
    const auto size = snapshot(world).size();
    const auto check = [&](const JointId& id, auto joint, const auto& change, std::size_t bytes,
                           const std::string& field) {
      auto other = world;
      change(joint);
      REQUIRE(other.change(id, joint));
      CHECK(snapshot(other).size() == size + bytes);
      CHECK(digest(other) != digest(world));
      const auto first = diff(world, other);
      REQUIRE(first);
      JointedWorld<S, N> fresh;
      put_body(fresh, 0);
      put_body(fresh, 1);
      REQUIRE(restore(fresh, snapshot(other)) == Restored::yes);
      CHECK(snapshot(fresh) == snapshot(other));
      using Joint = decltype(joint);
      CHECK(*fresh.template find_joint<Joint>(id) == joint);
      step_alike(other, fresh, 20);
      // Without the motion that waking bodies changed, the field is the first difference.
      auto& record = detail::WorldAccess::joints(world).list[id.index];
      const auto good = record.joint;
      auto copy = world;
      record.joint = decltype(record.joint)(joint);
      CHECK(std::string(diff(copy, world)->field.view()).ends_with(field));
      record.joint = good;
    };
    const auto hinge = *world.template find_joint<HingeJoint<S, N>>({2, 3});
    check(
        {2, 3}, hinge, [](auto& j) { j.angle = num<S>(0.1); }, 12, " angle");
    check(
        {2, 3}, hinge, [](auto& j) { j.frequency = S(3); }, 12, " frequency");
    check(
        {2, 3}, hinge, [](auto& j) { j.damping_ratio = S(0); }, 12, " damping_ratio");
    const auto weld = *world.template find_joint<WeldJoint<S, N>>({3, 1});
    check(
        {3, 1}, weld, [](auto& j) { j.frequency = S(3); }, 8, " frequency");
    check(
        {3, 1}, weld, [](auto& j) { j.damping_ratio = S(2); }, 8, " damping_ratio");
  });
}

TEST_CASE("joint: bits do not depend on the order of additions and removals") {
  in_both_dimensions([](auto dimension) {
    constexpr int N = decltype(dimension)::value;
    auto forward = scene<N>();
    JointedWorld<S, N> backward, changed;
    for (std::uint32_t i = body_count; i-- > 0;) put_body(backward, i);
    for (std::uint32_t i = joint_total; i-- > 0;) put_joint(backward, i);
    for (std::uint32_t i = 0; i < body_count; ++i) put_body(changed, i);
    for (std::uint32_t i = 0; i < joint_total; i += 2) put_joint(changed, i);
    REQUIRE(changed.remove(BodyId{3, 2}));  // removes joints 1 and 2 with it
    CHECK(!changed.contains(JointId{2, 3}));
    REQUIRE(changed.remove(JointId{4, 2}));
    put_body(changed, 3);
    for (std::uint32_t i = joint_total; i-- > 0;) {
      if (!changed.contains(JointId{i, 1 + i % 3})) put_joint(changed, i);
    }
    for (int t = 0; t < 200; ++t) {
      REQUIRE(digest(forward) == digest(backward));
      REQUIRE(digest(forward) == digest(changed));
      if (t == 60) {
        for (auto* world : {&forward, &backward, &changed}) REQUIRE(world->remove(BodyId{6, 1}));
        put_body(forward, 6);
        for (auto* world : {&backward, &changed}) put_body(*world, 6);
        for (auto* world : {&forward, &backward, &changed}) {
          put_joint(*world, world == &forward ? 4u : 5u);
          put_joint(*world, world == &forward ? 5u : 4u);
        }
      }
      for (auto* world : {&forward, &backward, &changed}) world->step();
    }
  });
}

TEST_CASE("joint: without its impulses a world diverges, and diff names the joint") {
  auto world = scene<2>();
  for (int t = 0; t < 20; ++t) world.step();
  auto other = world;
  auto& joint = detail::WorldAccess::joints(other).list[3];
  REQUIRE(joint.generation != 0);
  joint.turn = {};
  CHECK(digest(world) != digest(other));
  const auto first = diff(world, other);
  REQUIRE(first);
  CHECK(first->object == BodyId{4, 1});
  CHECK(std::string(first->field.view()).starts_with("joint 3:1 turn"));
  auto changed = *other.find_joint<WeldJoint<S, 2>>({3, 1});
  joint = detail::WorldAccess::joints(world).list[3];
  CHECK(!diff(world, other));
  changed.anchor_b.y = S(1);
  joint.joint = decltype(joint.joint)(changed);
  CHECK(std::string(diff(world, other)->field.view()) == "joint 3:1 anchor_b.y");
  joint = detail::WorldAccess::joints(world).list[3];
  joint.turn = {};
  world.step();
  other.step();
  CHECK(!(world.rotation(BodyId{5, 2}) == other.rotation(BodyId{5, 2})));
}

namespace {

/// Changes each byte of the header and of the joints. `fresh` has the fixed bodies of `world`.
template <class World>
void attack(const World& world, const World& fresh) {
  const auto good = snapshot(world);
  auto without = world;
  world.for_each_joint([&](const JointId& id) { (void)without.remove(id); });
  const auto joints_at = snapshot(without).size() - 8;
  const auto before = digest(fresh);
  int refused = 0, accepted = 0;
  const auto attempt = [&](Bytes bytes, bool steps) {
    seal(bytes);
    auto target = fresh;
    if (restore(target, bytes) == Restored::yes) {
      ++accepted;
      REQUIRE(snapshot(target) == bytes);  // every accepted snapshot is canonical
      for (int t = 0; steps && t < 3; ++t) target.step();
    } else {
      ++refused;
      REQUIRE(digest(target) == before);
    }
  };
  for (std::size_t i = 48; i + 8 < good.size(); i == 63 ? i = joints_at : ++i) {
    for (const int bit : {0, 5, 7}) {
      auto bytes = good;
      bytes[i] ^= static_cast<std::byte>(1 << bit);
      attempt(bytes, i % 8 == 0);
    }
  }
  CHECK(refused > 100);
  CHECK(accepted > 500);
}

}  // namespace

TEST_CASE("joint: hostile bytes change nothing and do no harm") {
  auto world = scene<3>();
  auto bending = *world.find_joint<WeldJoint<S, 3>>({9, 1});
  bending.frequency = S(3);
  REQUIRE(world.change({9, 1}, bending));
  for (int t = 0; t < 20; ++t) world.step();
  JointedWorld<S, 3> fresh;
  put_body(fresh, 0);
  put_body(fresh, 1);
  attack(world, fresh);

  auto chain = limbs();
  for (int t = 0; t < 20; ++t) chain.step();
  Limbs hook;
  put_limb(hook, 0);
  attack(chain, hook);
}

TEST_CASE("joint: other kinds, and worlds that are too small, are refused") {
  World<S, 2, Sphere, BallJoint> world;
  const auto a = *world.add(Sphere<S, 2>{at<S, 2>(0, 0), S(1)});
  const auto b = *world.add(Sphere<S, 2>{at<S, 2>(3, 0), S(1)});
  BallJoint<S, 2> joint;
  joint.a = a;
  joint.b = b;
  for (int i = 0; i < 5; ++i) REQUIRE(world.add(joint));
  const auto bytes = snapshot(world);
  World<S, 2, Sphere> no_joints;
  CHECK(restore(no_joints, bytes) == Restored::other_scene);
  World<S, 3, Sphere, Obb, BallJoint> no_cones;
  put_limb(no_cones, 0);
  CHECK(restore(no_cones, snapshot(limbs())) == Restored::other_scene);
  Limbs cones;
  put_limb(cones, 0);
  const auto without_joints = snapshot(no_cones);
  CHECK(snapshot(cones) == without_joints);  // a type that gets this kind keeps its snapshots
  CHECK(restore(cones, without_joints) == Restored::yes);
  World<S, 2, Sphere, HingeJoint> other_kind;
  CHECK(restore(other_kind, bytes) == Restored::other_scene);
  BoundedWorld<Bounded<2>, S, 2, Sphere, BallJoint> small;
  CHECK(restore(small, bytes) == Restored::no_room);
  BoundedWorld<Bounded<3>, S, 2, Sphere, BallJoint> large;
  CHECK(restore(large, bytes) == Restored::yes);
  CHECK(large.joint_count() == 5);
  const auto next = large.add(joint);
  REQUIRE(next);
  CHECK(*next == JointId{5, 6});
}

}  // namespace detent::test
