// SPDX-License-Identifier: MIT
// Transforms a child by its parent, and a point into the world and back.
#include <detent/math/math.hpp>
using namespace detent;

int main() {
  using Vec3 = Vec<q16_16, 3>;
  const auto quarter = Rotation<q16_16, 3>::from_euler({}, {}, Angle<q16_16>::turn(1, 4));
  const Transform<q16_16, 3> tank{Vec3{q16_16(10), q16_16(0), q16_16(0)}, quarter};
  const Transform<q16_16, 3> turret{Vec3{q16_16(2), q16_16(0), q16_16(1)}};
  const auto in_world = compose(tank, turret);
  const Vec3 muzzle = transform_point(in_world, Vec3{q16_16(3), q16_16(0), q16_16(0)});
  const bool is_there = muzzle == Vec3{q16_16(10), q16_16(5), q16_16(1)};
  return is_there && inverse_transform_point(in_world, muzzle).x == 3 ? 0 : 1;
}
