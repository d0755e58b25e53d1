// SPDX-License-Identifier: MIT
// Where does a ray first touch a shape, and where does it leave it?
#include <detent/query/raycast.hpp>
using namespace detent;

int main() {
  using Vec3 = Vec<q16_16, 3>;
  const Sphere target{Vec3{q16_16(0), q16_16(0), q16_16(20)}, q16_16(2)};
  const Ray shot{Vec3{}, Direction<q16_16, 3>::along(2), q16_16(100)};  // at most 100 units
  const auto hit = raycast_hit(shot, target);                           // distance, point, normal
  const auto span = raycast_interval(shot, target);                     // enter, exit
  const bool is_right = hit && hit->distance == 18 && hit->normal == -shot.direction;
  return is_right && span->exit == 22 && raycast(shot, target) == hit->distance ? 0 : 1;
}
