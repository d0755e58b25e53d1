// SPDX-License-Identifier: MIT
// Does a segment, such as a bullet's step or a line of sight, hit a shape?
#include <detent/query/intersects.hpp>
using namespace detent;

int main() {
  using Vec2 = Vec<q16_16, 2>;
  const Segment sight{Vec2{q16_16(-5), q16_16(0)}, Vec2{q16_16(5), q16_16(0)}};
  const Segment wall{Vec2{q16_16(0), q16_16(0)}, Vec2{q16_16(0), q16_16(9)}};
  const Triangle roof{Vec2{q16_16(1), q16_16(1)}, Vec2{q16_16(3), q16_16(1)},
                      Vec2{q16_16(2), q16_16(3)}};
  return intersects(sight, wall) && !intersects(sight, roof) ? 0 : 1;
}
