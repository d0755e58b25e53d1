// SPDX-License-Identifier: MIT
#include "accuracy/catalogue.hpp"
#include "accuracy/pair.hpp"
#include "detent/query/overlaps/plane_capsule.hpp"
#include "detent/query/overlaps/plane_triangle.hpp"
#include "detent/query/overlaps/triangle_capsule.hpp"
#include "detent/query/overlaps/triangle_triangle.hpp"

namespace detent::accuracy {

void add_flat_overlaps(std::vector<Query>& queries) {
  queries.push_back(
      overlap_query<Overlap<kind::Plane, kind::Triangle>>("overlaps/plane_triangle", 2));
  queries.push_back(
      overlap_query<Overlap<kind::Plane, kind::Capsule>>("overlaps/plane_capsule", 2));
  queries.push_back(
      overlap_query<Overlap<kind::Triangle, kind::Triangle>>("overlaps/triangle_triangle", 8));
  queries.push_back(
      overlap_query<Overlap<kind::Triangle, kind::Capsule>>("overlaps/triangle_capsule", 8));
}

}  // namespace detent::accuracy
