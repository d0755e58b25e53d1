// SPDX-License-Identifier: MIT
#include "accuracy/catalogue.hpp"
#include "accuracy/pair.hpp"
#include "detent/query/distance.hpp"

namespace detent::accuracy {

void add_planar_distances(std::vector<Query>& queries) {
  queries.push_back(
      pair_query<Apart<kind::Sphere, kind::Obb, 2>>("distance", "distance/sphere_obb_2d", 8));
  queries.push_back(pair_query<Apart<kind::Capsule, kind::Triangle, 2>>(
      "distance", "distance/capsule_triangle_2d", 8));
  queries.push_back(
      pair_query<Apart<kind::Obb, kind::Obb, 2>>("distance", "distance/obb_obb_2d", 16));
  queries.push_back(
      pair_query<Apart<kind::Hull, kind::Hull, 2>>("distance", "distance/hull_hull_2d", 40));
}

}  // namespace detent::accuracy
