// SPDX-License-Identifier: MIT
#include "accuracy/catalogue.hpp"
#include "accuracy/pair.hpp"
#include "detent/query/overlaps/aabb_hull.hpp"
#include "detent/query/overlaps/capsule_hull.hpp"
#include "detent/query/overlaps/hull_hull.hpp"
#include "detent/query/overlaps/obb_hull.hpp"
#include "detent/query/overlaps/plane_hull.hpp"
#include "detent/query/overlaps/sphere_hull.hpp"
#include "detent/query/overlaps/triangle_hull.hpp"

namespace detent::accuracy {

void add_planar_hull_overlaps(std::vector<Query>& queries) {
  queries.push_back(
      overlap_query<Overlap<kind::Sphere, kind::Hull, 2>>("overlaps/sphere_hull_2d", 8));
  queries.push_back(overlap_query<Overlap<kind::Aabb, kind::Hull, 2>>("overlaps/aabb_hull_2d", 8));
  queries.push_back(overlap_query<Overlap<kind::Obb, kind::Hull, 2>>("overlaps/obb_hull_2d", 8));
  queries.push_back(
      overlap_query<Overlap<kind::Plane, kind::Hull, 2>>("overlaps/plane_hull_2d", 2));
  queries.push_back(
      overlap_query<Overlap<kind::Triangle, kind::Hull, 2>>("overlaps/triangle_hull_2d", 8));
  queries.push_back(
      overlap_query<Overlap<kind::Capsule, kind::Hull, 2>>("overlaps/capsule_hull_2d", 8));
  queries.push_back(overlap_query<Overlap<kind::Hull, kind::Hull, 2>>("overlaps/hull_hull_2d", 8));
}

}  // namespace detent::accuracy
