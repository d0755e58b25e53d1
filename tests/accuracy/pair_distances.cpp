// SPDX-License-Identifier: MIT
#include "accuracy/catalogue.hpp"
#include "accuracy/pair.hpp"
#include "detent/query/distance.hpp"

namespace detent::accuracy {

void add_pair_distances(std::vector<Query>& queries) {
  queries.push_back(
      pair_query<Apart<kind::Sphere, kind::Obb>>("distance", "distance/sphere_obb", 8));
  queries.push_back(
      pair_query<Apart<kind::Capsule, kind::Triangle>>("distance", "distance/capsule_triangle", 8));
  queries.push_back(pair_query<Apart<kind::Obb, kind::Obb>>("distance", "distance/obb_obb", 16));
  queries.push_back(
      pair_query<Apart<kind::Hull, kind::Hull>>("distance", "distance/hull_hull", 40));
}

}  // namespace detent::accuracy
