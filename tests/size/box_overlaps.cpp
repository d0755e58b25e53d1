// SPDX-License-Identifier: MIT
//
// A program that tests any two of spheres, AABBs and OBBs for overlap.

#include "detent/query/overlaps/aabb_aabb.hpp"
#include "detent/query/overlaps/aabb_obb.hpp"
#include "detent/query/overlaps/obb_obb.hpp"
#include "detent/query/overlaps/sphere_aabb.hpp"
#include "detent/query/overlaps/sphere_obb.hpp"
#include "detent/query/overlaps/sphere_sphere.hpp"

using namespace detent;

struct Shapes {
  Sphere<SCALAR, 3> sphere;
  Aabb<SCALAR, 3> aabb;
  Obb<SCALAR, 3> obb;
};

extern "C" bool ask(const Shapes& a, const Shapes& b) {
  return overlaps(a.sphere, b.sphere) || overlaps(a.sphere, b.aabb) || overlaps(a.sphere, b.obb) ||
         overlaps(a.aabb, b.aabb) || overlaps(a.aabb, b.obb) || overlaps(a.obb, b.obb);
}
