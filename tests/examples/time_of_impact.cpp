// SPDX-License-Identifier: MIT
// When does a spinning rod hit a ball that flies past, and where are both at that time?
#include <detent/detent.hpp>
using namespace detent;
using namespace detent::literals;

int main() {
  using Vec3 = Vec<q16_16, 3>;
  const Capsule rod{Vec3{q16_16(-5), {}, {}}, Vec3{q16_16(5), {}, {}}, 0.25_q16_16};
  const Sphere ball{Vec3{}, q16_16(1)};
  const auto quarter = Rotation<q16_16, 3>::from_axis_angle(Direction<q16_16, 3>::along(2),
                                                            Angle<q16_16>::turn(1, 4));
  const Sweep spin{Vec3{}, Vec3{}, Rotation<q16_16, 3>{}, quarter};
  const Sweep fly{Vec3{q16_16(-9), q16_16(4), {}}, Vec3{q16_16(9), q16_16(4), {}}};
  const auto impact = time_of_impact(rod, spin, ball, fly);
  if (!impact || !impact->is_hit) return 1;
  // Moved to that time, they do not overlap yet but nearly touch.
  const auto hit_rod = placed(transform_at(spin, impact->time), rod);
  const auto hit_ball = placed(transform_at(fly, impact->time), ball);
  const bool is_near = distance(hit_rod, hit_ball) <= 0.0002_q16_16;
  return !overlaps(hit_rod, hit_ball) && is_near && impact->time < 0.75_q16_16 ? 0 : 1;
}
