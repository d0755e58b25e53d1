// SPDX-License-Identifier: MIT
// A convex shape from its corners, and several shapes as one.
#include <array>
#include <detent/query/query.hpp>
using namespace detent;

int main() {
  using Vec2 = Vec<q16_16, 2>;
  const std::array corners{Vec2{q16_16(0), q16_16(0)}, Vec2{q16_16(4), q16_16(0)},
                           Vec2{q16_16(5), q16_16(2)}, Vec2{q16_16(1), q16_16(3)}};
  const std::array hulls{ConvexHull<q16_16, 2>{corners}};
  const std::array wheels{Sphere{Vec2{q16_16(1), q16_16(-1)}, q16_16(1)},
                          Sphere{Vec2{q16_16(3), q16_16(-1)}, q16_16(1)}};
  const Compound car{hulls, wheels};
  const Ray gaze{Vec2{q16_16(-9), q16_16(-1)}, Direction<q16_16, 2>::along(0)};
  return overlaps(car, wheels[0]) && raycast(gaze, car) == 9 ? 0 : 1;
}
