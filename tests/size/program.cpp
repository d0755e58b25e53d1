// SPDX-License-Identifier: MIT
//
// A program with one query that takes more than two shapes. Needs the macros SCALAR and PROGRAM, one
// of those below.

#include <cstddef>
#include <optional>

#include "detent/detent.hpp"

using namespace detent;

#define pick_ray_program 1
#define project_program 2
#define frustum_aabb_program 3
#define time_of_impact_program 4
#define mesh_contacts_program 5
#define scene_cast_program 6
#define mover_program 7

using Bodies = BoundedScene<Bounded<16>, SCALAR, 3, Aabb, Obb>;

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
#elif PROGRAM == mesh_contacts_program
extern "C" std::size_t ask(const Mesh<SCALAR>& mesh, const Obb<SCALAR, 3>& box,
                           MeshContact<SCALAR>* found, std::size_t count) {
  return contacts(mesh, box, {found, count});
}
#elif PROGRAM == scene_cast_program
extern "C" bool ask(const Bodies& scene, const Cast<Capsule<SCALAR, 3>>& cast) {
  return scene.nearest(cast).has_value();
}
#elif PROGRAM == mover_program
extern "C" std::size_t ask(const Bodies& scene, Mover<SCALAR, 3, Capsule>& mover,
                           const Vec<SCALAR, 3>& by) {
  return mover.move(scene, by).count;
}
#endif
