// SPDX-License-Identifier: MIT
//
// A program with a query of a camera or of moving bodies. Needs the macros SCALAR and PROGRAM, one
// of those below.

#include <optional>

#include "detent/detent.hpp"

using namespace detent;

#define pick_ray_program 1
#define project_program 2
#define frustum_aabb_program 3
#define time_of_impact_program 4

#if PROGRAM == pick_ray_program
extern "C" void ask(const Camera<SCALAR>& camera, const Viewport& screen, int column, int row,
                    Ray<SCALAR, 3>& ray) {
  ray = pick_ray(camera, screen, column, row);
}
#elif PROGRAM == project_program
extern "C" bool ask(const Camera<SCALAR>& camera, const Viewport& screen,
                    const Vec<SCALAR, 3>& point, ScreenPoint<SCALAR, SCALAR>& found) {
  const auto answer = project(camera, screen, point);
  if (answer) found = *answer;
  return answer.has_value();
}
#elif PROGRAM == frustum_aabb_program
extern "C" bool ask(const Frustum<SCALAR>& frustum, const Aabb<SCALAR, 3>& box) {
  return overlaps(frustum, box);
}
#elif PROGRAM == time_of_impact_program
using Body = Obb<SCALAR, 3>;
using Motion3 = Sweep<SCALAR, 3>;
extern "C" bool ask(const Body& a, const Motion3& by_a, const Body& b, const Motion3& by_b,
                    Impact<SCALAR>& found) {
  const auto answer = time_of_impact(a, by_a, b, by_b);
  if (answer) found = *answer;
  return answer.has_value();
}
#endif
