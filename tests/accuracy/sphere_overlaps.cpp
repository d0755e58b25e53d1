// SPDX-License-Identifier: MIT
#include "accuracy/catalogue.hpp"
#include "accuracy/pair.hpp"
#include "detent/query/overlaps/sphere_aabb.hpp"
#include "detent/query/overlaps/sphere_capsule.hpp"
#include "detent/query/overlaps/sphere_hull.hpp"
#include "detent/query/overlaps/sphere_obb.hpp"
#include "detent/query/overlaps/sphere_plane.hpp"
#include "detent/query/overlaps/sphere_sphere.hpp"
#include "detent/query/overlaps/sphere_triangle.hpp"

namespace detent::accuracy {

void add_sphere_overlaps(std::vector<Query>& queries) {
  queries.push_back(
      overlap_query<Overlap<kind::Sphere, kind::Sphere>>("overlaps/sphere_sphere", 2));
  queries.push_back(overlap_query<Overlap<kind::Sphere, kind::Aabb>>("overlaps/sphere_aabb", 2));
  queries.push_back(overlap_query<Overlap<kind::Sphere, kind::Obb>>("overlaps/sphere_obb", 2));
  queries.push_back(overlap_query<Overlap<kind::Sphere, kind::Plane>>("overlaps/sphere_plane", 2));
  queries.push_back(
      overlap_query<Overlap<kind::Sphere, kind::Triangle>>("overlaps/sphere_triangle", 2));
  queries.push_back(
      overlap_query<Overlap<kind::Sphere, kind::Capsule>>("overlaps/sphere_capsule", 2));
  queries.push_back(overlap_query<Overlap<kind::Sphere, kind::Hull>>("overlaps/sphere_hull", 8));
}

}  // namespace detent::accuracy
