// SPDX-License-Identifier: MIT
// Is a point on something thin, exactly or within a given tolerance?
#include <detent/query/on.hpp>
using namespace detent;

int main() {
  using Vec2 = Vec<q16_16, 2>;
  const Segment edge{Vec2{}, Vec2{q16_16(6), q16_16(8)}};
  const Vec2 middle{q16_16(3), q16_16(4)}, beside{q16_16(3), q16_16(5)};
  return on(edge, middle) && !on(edge, beside) && on(edge, beside, q16_16(1)) ? 0 : 1;
}
