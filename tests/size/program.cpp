// SPDX-License-Identifier: MIT
//
// A program with a query of a camera, of moving bodies, of a mesh or of a scene. Needs the macros
// SCALAR and PROGRAM, one of those below.

#include <cstddef>
#include <optional>
#include <span>

#include "detent/detent.hpp"
#include "detent/scene/mesh.hpp"
#include "detent/scene/mover.hpp"
#include "detent/scene/scene.hpp"

using namespace detent;

#define pick_ray_program 1
#define project_program 2
#define frustum_aabb_program 3
#define time_of_impact_program 4
#define mesh_sphere_program 5
#define mesh_capsule_program 6
#define mesh_obb_program 7
#define scene_cast_program 8
#define character_program 9

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
#elif PROGRAM == mesh_sphere_program || PROGRAM == mesh_capsule_program || \
    PROGRAM == mesh_obb_program
#if PROGRAM == mesh_sphere_program
using Body = Sphere<SCALAR, 3>;
#elif PROGRAM == mesh_capsule_program
using Body = Capsule<SCALAR, 3>;
#else
using Body = Obb<SCALAR, 3>;
#endif
extern "C" std::size_t ask(const Mesh<SCALAR>& mesh, const Body& body,
                           std::span<MeshContact<SCALAR>> found) {
  return contacts(mesh, body, found);
}
#else
using Level = BoundedScene<Bounded<16, 1>, SCALAR, 3, Aabb, Sphere>;
#if PROGRAM == scene_cast_program
extern "C" bool ask(const Level& level, const Cast<Sphere<SCALAR, 3>>& ball, SCALAR& distance) {
  const auto answer = level.nearest(ball);
  if (answer) distance = answer->distance;
  return answer.has_value();
}
#else
extern "C" void ask(const Level& level, Mover<SCALAR, 3, Capsule>& player, const Vec<SCALAR, 3>& by,
                    MoveResult<SCALAR, 3>& result) {
  result = player.move(level, by);
}
#endif
#endif
