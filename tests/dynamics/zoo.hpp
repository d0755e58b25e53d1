// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "detent/dynamics/dynamics.hpp"
#include "dynamics/terrain.hpp"
#include "support/random.hpp"

namespace detent::test {

/// A dimension, as a parameter of a test case.
template <int N>
struct Dim {
  static constexpr int value = N;
};

template <Scalar S, int N>
struct ZooWorld {
  using Type = World<S, 3, Sphere, Capsule, Aabb, Obb, BodyHull, BodyCompound, BodyMesh,
                     BodyHeightField, BallJoint>;
};
template <Scalar S>
struct ZooWorld<S, 2> {
  using Type = World<S, 2, Sphere, Capsule, Aabb, Obb, BodyHull, BodyCompound, BallJoint>;
};

/// A world of bodies of every kind, which come, go, fall asleep and are put elsewhere at random.
template <Scalar S, int N>
class Zoo {
 public:
  using Bodies = typename ZooWorld<S, N>::Type;
  using Point = Vec<S, N>;

  explicit Zoo(std::uint64_t seed) : random(seed), world(restful()) {
    BodyOptions<S, N> fixed;
    fixed.motion = BodyMotion::fixed;
    if constexpr (N == 3) {
      world.add(BodyMesh<S, 3>{&ground_.asset, at(0, -1), {}}, fixed);
      world.add(BodyHeightField<S, 3>{&terrain_, at(0, -2)}, fixed);
    }
    world.add(box(at(0, -3), 12, 1), fixed);
    for (int i = 0; i < 20; ++i) add();
  }
  Zoo(const Zoo&) = delete;
  Zoo& operator=(const Zoo&) = delete;

  /// Some ticks, and a few additions, removals and other changes.
  void live() {
    for (auto n = random.below(4); n > 0; --n) add();
    for (auto n = random.below(3); n > 0; --n) world.remove(any());
    if (random.coin()) world.set_position(any(), somewhere());
    if (random.coin()) world.set_rotation(any(), turn());
    for (auto n = random.below(random.one_in(4) ? 60 : 6); n > 0; --n) world.step();
  }
  /// The id of a body.
  [[nodiscard]] BodyId any() {
    std::vector<BodyId> ids;
    world.for_each([&](const BodyInfo& body) { ids.push_back(body.id); });
    return ids.empty() ? no_object : ids[random.below(ids.size())];
  }
  [[nodiscard]] S number(double limit) {
    return num<S>(limit * static_cast<double>(random.between(-1000, 1000)) / 1000);
  }
  [[nodiscard]] Point somewhere() {
    Point p{};
    for (int i = 0; i < N; ++i) p[i] = number(6);
    p.y = nearest_to<S>(num<S>(3) + number(2));
    return p;
  }
  [[nodiscard]] Direction<S, N> direction() {
    Point p{};
    for (int i = 0; i < N; ++i) p[i] = number(4);
    return direction_of<S>(p).value_or(Direction<S, N>::along(0));
  }

  /// What a snapshot needs to be restored.
  [[nodiscard]] std::span<const SolidHull<S, N>> hulls() const { return {&hull_, 1}; }
  [[nodiscard]] std::span<const SolidCompound<S, N>> compounds() const { return {&compound_, 1}; }

  Random random;
  Bodies world;

 private:
  [[nodiscard]] static WorldSettings<S, N> restful() {
    WorldSettings<S, N> settings;
    settings.sleep_speed = num<S>(0.5);
    return settings;
  }
  [[nodiscard]] Point at(double x, double y) const {
    Point p{};
    p.x = num<S>(x);
    p.y = num<S>(y);
    return p;
  }
  [[nodiscard]] static Obb<S, N> box(const Point& center, double half, double half_height) {
    Obb<S, N> box{center, {}, {}};
    for (int i = 0; i < N; ++i) box.half_extents[i] = num<S>(half);
    box.half_extents.y = num<S>(half_height);
    return box;
  }
  [[nodiscard]] Rotation<S, N> turn() {
    const auto angle = Angle<S>::turn(static_cast<int>(random.below(360)), 360);
    if constexpr (N == 2) {
      return Rotation<S, 2>::from_angle(angle);
    } else {
      return Rotation<S, 3>::from_axis_angle(direction(), angle);
    }
  }
  void add() {
    BodyOptions<S, N> options;
    options.user = random.next();
    options.layers = static_cast<std::uint32_t>(random.between(1, 3));
    options.is_sensor = random.one_in(6);
    options.angular_velocity[0] = number(2);
    options.linear_damping = options.angular_damping = num<S>(4);
    if (random.one_in(6)) options.motion = BodyMotion::fixed;
    if (random.one_in(8)) options.motion = BodyMotion::kinematic;
    const auto there = somewhere();
    const auto half = nearest_to<S>(num<S>(0.4) + number(0.2));
    const auto most = make_vec<N>([&](int i) { return nearest_to<S>(there[i] + half); });
    const auto far = nearest_to<S>(there + at(0.5, 0.25));
    std::optional<BodyId> id;
    switch (random.below(7)) {
      case 0:
        id = world.add(Sphere<S, N>{there, half}, options);
        break;
      case 1:
        id = world.add(Capsule<S, N>{there, far, half}, options);
        break;
      case 2:
        id = world.add(Aabb<S, N>{there, most}, options);
        break;
      case 3:
        id = world.add(BodyHull<S, N>{&hull_, there, turn()}, options);
        break;
      case 4:
      case 5:
        id = world.add(BodyCompound<S, N>{&compound_, there, turn()}, options);
        break;
      default:
        id = world.add(Obb<S, N>{there, box(there, 0.5, 0.25).half_extents, turn()}, options);
    }
    if (random.one_in(8)) {
      BallJoint<S, N> joint;
      joint.a = id.value_or(no_object);
      joint.b = any();
      world.add(joint);
    }
  }

  std::array<Point, N == 2 ? 3 : 4> corners_ = [] {
    std::array<Point, N == 2 ? 3 : 4> corners{};
    for (int i = 0; i < N; ++i) corners[static_cast<std::size_t>(i)][i] = num<S>(0.75);
    return corners;
  }();
  SolidHull<S, N> hull_ = solid_hull(1, ConvexHull<S, N>{corners_}).value();
  std::array<BodyPart<S, N>, 4> parts_{
      BodyPart(box({}, 0.5, 0.125)), BodyPart(Sphere<S, N>{at(0.5, 0), num<S>(0.25)}),
      BodyPart(Sphere<S, N>{at(0.5, 0), num<S>(1)}, {.density = {}, .is_sensor = true}),
      BodyPart(BodyHull<S, N>{&hull_, at(-0.5, 0.25), {}})};
  SolidCompound<S, N> compound_ = solid_compound(2, parts_).value();
  Owned<S> ground_{square<S>(4, 8, [](double x, double z) { return (x + z) / 32; })};
  std::array<S, 25> heights_{};
  FieldAsset<S> terrain_{3, *height_field<S>({num<S>(-8), num<S>(-8)}, num<S>(4), 5, 5, heights_)};
};

}  // namespace detent::test
