// SPDX-License-Identifier: MIT
#include "accuracy/catalogue.hpp"
#include "accuracy/pair.hpp"
#include "detent/query/overlaps/aabb_aabb.hpp"
#include "detent/query/overlaps/aabb_obb.hpp"
#include "detent/query/overlaps/aabb_plane.hpp"
#include "detent/query/overlaps/aabb_triangle.hpp"
#include "detent/query/overlaps/obb_obb.hpp"
#include "detent/query/overlaps/obb_plane.hpp"
#include "detent/query/overlaps/obb_triangle.hpp"
#include "detent/query/overlaps/plane_triangle.hpp"
#include "detent/query/overlaps/triangle_triangle.hpp"

namespace detent::accuracy {

void add_planar_flat_overlaps(std::vector<Query>& queries) {
  queries.push_back(overlap_query<Overlap<kind::Aabb, kind::Aabb, 2>>("overlaps/aabb_aabb_2d", 2));
  queries.push_back(overlap_query<Overlap<kind::Aabb, kind::Obb, 2>>("overlaps/aabb_obb_2d", 8));
  queries.push_back(
      overlap_query<Overlap<kind::Aabb, kind::Plane, 2>>("overlaps/aabb_plane_2d", 2));
  queries.push_back(
      overlap_query<Overlap<kind::Aabb, kind::Triangle, 2>>("overlaps/aabb_triangle_2d", 8));
  queries.push_back(overlap_query<Overlap<kind::Obb, kind::Obb, 2>>("overlaps/obb_obb_2d", 8));
  queries.push_back(overlap_query<Overlap<kind::Obb, kind::Plane, 2>>("overlaps/obb_plane_2d", 2));
  queries.push_back(
      overlap_query<Overlap<kind::Obb, kind::Triangle, 2>>("overlaps/obb_triangle_2d", 8));
  queries.push_back(
      overlap_query<Overlap<kind::Plane, kind::Triangle, 2>>("overlaps/plane_triangle_2d", 2));
  queries.push_back(overlap_query<Overlap<kind::Triangle, kind::Triangle, 2>>(
      "overlaps/triangle_triangle_2d", 8));
}

}  // namespace detent::accuracy
