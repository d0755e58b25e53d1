// SPDX-License-Identifier: MIT
#include "accuracy/catalogue.hpp"
#include "accuracy/pair.hpp"
#include "detent/query/overlaps/aabb_capsule.hpp"
#include "detent/query/overlaps/capsule_capsule.hpp"
#include "detent/query/overlaps/obb_capsule.hpp"
#include "detent/query/overlaps/plane_capsule.hpp"
#include "detent/query/overlaps/sphere_aabb.hpp"
#include "detent/query/overlaps/sphere_capsule.hpp"
#include "detent/query/overlaps/sphere_obb.hpp"
#include "detent/query/overlaps/sphere_plane.hpp"
#include "detent/query/overlaps/sphere_sphere.hpp"
#include "detent/query/overlaps/sphere_triangle.hpp"
#include "detent/query/overlaps/triangle_capsule.hpp"

namespace detent::accuracy {

void add_planar_round_overlaps(std::vector<Query>& queries) {
  queries.push_back(
      overlap_query<Overlap<kind::Sphere, kind::Sphere, 2>>("overlaps/sphere_sphere_2d", 2));
  queries.push_back(
      overlap_query<Overlap<kind::Sphere, kind::Aabb, 2>>("overlaps/sphere_aabb_2d", 2));
  queries.push_back(
      overlap_query<Overlap<kind::Sphere, kind::Obb, 2>>("overlaps/sphere_obb_2d", 2));
  queries.push_back(
      overlap_query<Overlap<kind::Sphere, kind::Plane, 2>>("overlaps/sphere_plane_2d", 2));
  queries.push_back(
      overlap_query<Overlap<kind::Sphere, kind::Triangle, 2>>("overlaps/sphere_triangle_2d", 2));
  queries.push_back(
      overlap_query<Overlap<kind::Sphere, kind::Capsule, 2>>("overlaps/sphere_capsule_2d", 2));
  queries.push_back(
      overlap_query<Overlap<kind::Aabb, kind::Capsule, 2>>("overlaps/aabb_capsule_2d", 8));
  queries.push_back(
      overlap_query<Overlap<kind::Obb, kind::Capsule, 2>>("overlaps/obb_capsule_2d", 8));
  queries.push_back(
      overlap_query<Overlap<kind::Plane, kind::Capsule, 2>>("overlaps/plane_capsule_2d", 2));
  queries.push_back(
      overlap_query<Overlap<kind::Triangle, kind::Capsule, 2>>("overlaps/triangle_capsule_2d", 8));
  queries.push_back(
      overlap_query<Overlap<kind::Capsule, kind::Capsule, 2>>("overlaps/capsule_capsule_2d", 2));
}

}  // namespace detent::accuracy
