// SPDX-License-Identifier: MIT
// The bounding box or sphere of shapes or points, and the size of a shape.
#include <detent/shape/shape.hpp>
using namespace detent;

int main() {
  using Vec2 = Vec<q16_16, 2>;
  const Triangle sail{Vec2{}, Vec2{q16_16(6), q16_16(0)}, Vec2{q16_16(0), q16_16(8)}};
  const Aabb box = bounding_box(sail);
  const Sphere disc = bounding_sphere(sail);
  return box.max.y == 8 && disc.radius == 5 && area(sail) == 24 ? 0 : 1;
}
