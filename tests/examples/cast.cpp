// SPDX-License-Identifier: MIT
// How far can a ball move before it touches a wall, and what does it touch there?
#include <detent/query/cast.hpp>
using namespace detent;

int main() {
  using Vec3 = Vec<q16_16, 3>;
  const Sphere ball{Vec3{}, q16_16(1)};
  const Aabb wall{Vec3{q16_16(5), q16_16(-9), q16_16(-9)}, Vec3{q16_16(6), q16_16(9), q16_16(9)}};
  const auto ahead = Direction<q16_16, 3>::along(0);
  const auto hit = cast(ball, ahead, q16_16(100), wall);  // distance, point, normal
  const bool is_right = hit && hit->distance == 4 && hit->normal == -ahead;
  const Cast question{ball, ahead, q16_16(3)};  // the same as one value, at most 3 units far
  return is_right && hit->point == Vec3{q16_16(5), {}, {}} && !cast(question, wall) ? 0 : 1;
}
