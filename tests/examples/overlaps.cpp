// SPDX-License-Identifier: MIT
// Do two shapes share a point? Any two, in either order; touching counts.
#include <detent/query/overlaps.hpp>
using namespace detent;

int main() {
  using Vec3 = Vec<q16_16, 3>;
  const Sphere ball{Vec3{q16_16(0), q16_16(3), q16_16(0)}, q16_16(1)};
  const Capsule hero{Vec3{}, Vec3{q16_16(0), q16_16(1), q16_16(0)}, q16_16(1)};
  const auto turned = Rotation<q16_16, 3>::from_euler({}, Angle<q16_16>::turn(1, 8), {});
  const Obb<q16_16, 3> crate{Vec3{q16_16(2), q16_16(0), q16_16(0)},
                             Vec3{q16_16(1), q16_16(1), q16_16(1)}, turned};
  return overlaps(ball, hero) && overlaps(crate, hero) && !overlaps(ball, crate) ? 0 : 1;
}
