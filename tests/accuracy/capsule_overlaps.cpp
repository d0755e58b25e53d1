// SPDX-License-Identifier: MIT
#include "accuracy/catalogue.hpp"
#include "accuracy/pair.hpp"
#include "detent/query/overlaps/capsule_capsule.hpp"
#include "detent/query/overlaps/capsule_hull.hpp"

namespace detent::accuracy {

void add_capsule_overlaps(std::vector<Query>& queries) {
  queries.push_back(
      overlap_query<Overlap<kind::Capsule, kind::Capsule>>("overlaps/capsule_capsule", 2));
  queries.push_back(overlap_query<Overlap<kind::Capsule, kind::Hull>>("overlaps/capsule_hull", 8));
}

}  // namespace detent::accuracy
