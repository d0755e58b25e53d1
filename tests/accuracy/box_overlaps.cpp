// SPDX-License-Identifier: MIT
#include "accuracy/catalogue.hpp"
#include "accuracy/pair.hpp"
#include "detent/query/overlaps/aabb_aabb.hpp"
#include "detent/query/overlaps/aabb_capsule.hpp"
#include "detent/query/overlaps/aabb_obb.hpp"
#include "detent/query/overlaps/aabb_plane.hpp"
#include "detent/query/overlaps/aabb_triangle.hpp"
#include "detent/query/overlaps/obb_capsule.hpp"
#include "detent/query/overlaps/obb_obb.hpp"
#include "detent/query/overlaps/obb_plane.hpp"
#include "detent/query/overlaps/obb_triangle.hpp"

namespace detent::accuracy {

void add_box_overlaps(std::vector<Query>& queries) {
  queries.push_back(overlap_query<Overlap<kind::Aabb, kind::Aabb>>("overlaps/aabb_aabb", 2));
  queries.push_back(overlap_query<Overlap<kind::Aabb, kind::Obb>>("overlaps/aabb_obb", 8));
  queries.push_back(overlap_query<Overlap<kind::Aabb, kind::Plane>>("overlaps/aabb_plane", 2));
  queries.push_back(
      overlap_query<Overlap<kind::Aabb, kind::Triangle>>("overlaps/aabb_triangle", 8));
  queries.push_back(overlap_query<Overlap<kind::Aabb, kind::Capsule>>("overlaps/aabb_capsule", 8));
  queries.push_back(overlap_query<Overlap<kind::Obb, kind::Obb>>("overlaps/obb_obb", 8));
  queries.push_back(overlap_query<Overlap<kind::Obb, kind::Plane>>("overlaps/obb_plane", 2));
  queries.push_back(overlap_query<Overlap<kind::Obb, kind::Triangle>>("overlaps/obb_triangle", 8));
  queries.push_back(overlap_query<Overlap<kind::Obb, kind::Capsule>>("overlaps/obb_capsule", 8));
}

}  // namespace detent::accuracy
