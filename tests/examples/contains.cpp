// SPDX-License-Identifier: MIT
// Is a point in a shape, how far away is it, and which point of the shape is nearest?
#include <detent/query/closest_point.hpp>
#include <detent/query/contains.hpp>
#include <detent/query/distance.hpp>
using namespace detent;

int main() {
  using Vec3 = Vec<q16_16, 3>;
  const Aabb room{Vec3{q16_16(-4), q16_16(0), q16_16(-4)}, Vec3{q16_16(4), q16_16(3), q16_16(4)}};
  const Vec3 player{q16_16(7), q16_16(1), q16_16(8)};
  const bool is_inside = contains(room, player);
  const q16_16 apart = distance(room, player);        // rounded down
  const Vec3 doorstep = closest_point(room, player);  // to nearest
  return !is_inside && apart == 5 && doorstep.x == 4 ? 0 : 1;
}
