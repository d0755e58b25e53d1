// SPDX-License-Identifier: MIT
#include "accuracy/catalogue.hpp"
#include "accuracy/pair.hpp"
#include "detent/query/overlaps/aabb_hull.hpp"
#include "detent/query/overlaps/hull_hull.hpp"
#include "detent/query/overlaps/obb_hull.hpp"
#include "detent/query/overlaps/plane_hull.hpp"
#include "detent/query/overlaps/triangle_hull.hpp"

namespace detent::accuracy {

void add_hull_overlaps(std::vector<Query>& queries) {
  queries.push_back(overlap_query<Overlap<kind::Aabb, kind::Hull>>("overlaps/aabb_hull", 8));
  queries.push_back(overlap_query<Overlap<kind::Obb, kind::Hull>>("overlaps/obb_hull", 8));
  queries.push_back(overlap_query<Overlap<kind::Plane, kind::Hull>>("overlaps/plane_hull", 2));
  queries.push_back(
      overlap_query<Overlap<kind::Triangle, kind::Hull>>("overlaps/triangle_hull", 8));
  queries.push_back(overlap_query<Overlap<kind::Hull, kind::Hull>>("overlaps/hull_hull", 8));
}

}  // namespace detent::accuracy
