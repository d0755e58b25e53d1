// SPDX-License-Identifier: MIT
#pragma once

#include "detent/scene/mover.hpp"
#include "support/catch.hpp"

namespace detent::test {

/// A level of boxes, in hundredths of a unit.
template <Scalar S>
struct Level {
  static S number(int hundredths) {
    return quotient_nearest<S>(detail::as_operand<S>(hundredths), detail::as_operand<S>(100));
  }
  static Vec<S, 3> at(int x, int y, int z) { return {number(x), number(y), number(z)}; }
  using World = Scene<S, 3, Aabb, Obb>;
  using Walker = Mover<S, 3, Capsule>;

  World world;

  ObjectId box(const Vec<S, 3>& min, const Vec<S, 3>& max, const Traits& traits = {}) {
    return world.add(Aabb<S, 3>{min, max}, traits).value_or(no_object);
  }
  ObjectId floor(int height = 0) {
    return box(at(-2000, height - 100, -2000), at(2000, height, 2000));
  }
  /// A slope that rises along x, through the origin.
  ObjectId slope(int degrees) { return slope(degrees, at(0, 0, 0)); }
  /// A slope that rises along x from an edge, which overhangs the floor.
  ObjectId ledge(int degrees, int height) {
    return slope(degrees, nearest_to<S>(turn(degrees).axis(0) * number(1000) + at(0, height, 0)));
  }

  /// A person 1.8 high, with its feet at a point.
  static Walker person(int x, int y, int z) {
    return {{at(x, y + 40, z), at(x, y + 140, z), number(40)}};
  }
  static double feet(const Walker& walker) {
    return double(walker.shape.a.y) - double(walker.shape.radius);
  }
  static double x(const Walker& walker) { return double(walker.shape.a.x); }
  static double z(const Walker& walker) { return double(walker.shape.a.z); }

  MoverSettings<S, 3> settings{};

  /// Walks for some frames, falling 4 hundredths per frame.
  MoveResult<S, 3> walk(Walker& walker, int frames, int east, int south = 0) {
    MoveResult<S, 3> result;
    for (int i = 0; i < frames; ++i) {
      result = walker.move(world, at(east, -4, south), settings);
    }
    return result;
  }

 private:
  static Rotation<S, 3> turn(int degrees) {
    return Rotation<S, 3>::from_axis_angle(Direction<S, 3>::along(2), Angle<S>::turn(degrees, 360));
  }
  ObjectId slope(int degrees, const Vec<S, 3>& middle) {
    const auto center = nearest_to<S>(middle + turn(degrees).axis(1) * -number(200));
    return world.add(Obb<S, 3>{center, at(1000, 200, 1000), turn(degrees)}).value_or(no_object);
  }
};

}  // namespace detent::test
