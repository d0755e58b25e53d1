// SPDX-License-Identifier: MIT
// A scene: objects, some of them in a frame; a ray's hit; and ids that are safe to use even if
// there was no room for an object.
#include <detent/scene/snapshot.hpp>
using namespace detent;

using Vec3 = Vec<q16_16, 3>;
using Arena = BoundedScene<Bounded<4, 1>, q16_16, 3, Sphere, Obb>;  // four objects and one frame

Vec3 at(int x, int y, int z) { return {q16_16(x), q16_16(y), q16_16(z)}; }

int main() {
  Arena arena;
  // A full scene adds nothing. Every function returns false, or nothing, for `no_object`.
  const ObjectId ball = arena.add(Sphere{at(5, 0, 0), q16_16(1)}).value_or(no_object);
  if (!arena.move(ball, at(0, 0, 1))) return 1;

  const FrameId ship = arena.add_frame({.translation = at(20, 0, 0)}).value_or(no_frame);
  const Obb<q16_16, 3> cabin{at(0, 0, 2), at(1, 1, 1), {}};  // in the coordinates of the ship
  const ObjectId box = arena.add(cabin, {.layers = 2, .frame = ship}).value_or(no_object);
  arena.move_frame(ship, {.translation = at(30, 0, 0)});
  if (arena.local_shape<Obb<q16_16, 3>>(box) != cabin) return 2;
  if (arena.shape<Obb<q16_16, 3>>(box)->center != at(30, 0, 2)) return 3;  // in the world

  const Ray ray{at(0, 0, 1), Direction<q16_16, 3>::along(0)};
  const auto hit = arena.nearest_hit(ray);
  if (!hit || hit->id != ball || hit->distance != 4 || hit->point != at(4, 0, 1)) return 4;
  if (hit->normal != -ray.direction) return 5;
  if (arena.nearest_hit(ray, InLayers{2})->distance != 29) return 6;

  int boxes = 0;
  arena.visit(box, [&](const auto& shape) { boxes += bounding_box(shape).min.x == 29 ? 1 : 0; });
  return boxes == 1 ? 0 : 7;
}
