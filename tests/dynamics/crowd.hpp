// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "detent/dynamics/dynamics.hpp"
#include "detent/dynamics/snapshot.hpp"
#include "dynamics/terrain.hpp"
#include "support/random.hpp"

namespace detent::test {

/// Many random bodies of several kinds that fall onto terrain: enough work for several threads.
class Crowd {
 public:
  using S = q16_16;
  using Bodies = World<S, 3, Obb, BodyCompound, BodyMesh, BallJoint>;

  explicit Crowd(std::uint64_t seed, double hold_distance = 0.1)
      : random_(seed), world_(settings(hold_distance)) {
    world_.add(BodyMesh<S, 3>{&ground_.asset, {}, {}}, fixed<S>());
    world_.add(box_of<S, 3>(0, -4, 1, 4), fixed<S>());
    auto last = no_object;
    for (int i = 0; i < 130; ++i) {
      BodyOptions<S, 3> options;
      options.velocity = {number(4), number(4), number(4)};
      options.restitution = random_.coin() ? num<S>(0.3) : S(0);
      options.is_sensor = random_.one_in(20);
      options.is_fast = random_.one_in(20);
      const Vec<S, 3> at{number(2), num<S>(0.5 + 0.03 * i), number(2)};
      const auto id = add(at, options).value_or(no_object);
      if (random_.one_in(12)) {
        BallJoint<S, 3> joint;
        joint.a = last;
        joint.b = id;
        joint.anchor_a = world_.local_point(last, at);
        world_.add(joint);
      }
      last = id;
    }
  }
  Crowd(const Crowd&) = delete;
  Crowd& operator=(const Crowd&) = delete;

  [[nodiscard]] const Bodies& world() const noexcept { return world_; }
  /// The assets of its bodies, to restore a snapshot.
  [[nodiscard]] std::span<const SolidCompound<S, 3>> compounds() const noexcept {
    return {&solid_, 1};
  }
  [[nodiscard]] std::span<const MeshAsset<S>> meshes() const noexcept {
    return {&ground_.asset, 1};
  }

 private:
  static WorldSettings<S, 3> settings(double hold_distance) {
    WorldSettings<S, 3> settings;
    settings.hold_distance = num<S>(hold_distance);
    return settings;
  }
  std::optional<BodyId> add(const Vec<S, 3>& at, const BodyOptions<S, 3>& options) {
    if (random_.one_in(8)) return world_.add(BodyCompound<S, 3>{&solid_, at, {}}, options);
    return world_.add(Obb<S, 3>{at, point<S>(0.5, 0.25, 0.4), {}}, options);
  }
  S number(int limit) {
    return S::from_raw(static_cast<int>(random_.between(-limit * 65536, limit * 65536)));
  }

  Random random_;
  Owned<S> ground_{square<S>(8, 10, level)};
  std::array<BodyPart<S, 3>, 2> parts_{BodyPart(box_of<S, 3>(0, 0, 0.5, 0.125)),
                                       BodyPart(box_of<S, 3>(0.5, 0, 0.25, 0.25))};
  SolidCompound<S, 3> solid_ = solid_compound(7, parts_).value();
  Bodies world_;
};

}  // namespace detent::test
