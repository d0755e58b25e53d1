// SPDX-License-Identifier: MIT
#include "accuracy/catalogue.hpp"
#include "accuracy/pair.hpp"
#include "accuracy/pair_points.hpp"

namespace detent::accuracy {

void add_round_closest_points(std::vector<Query>& queries) {
  queries.push_back(
      closest_points_query<Closest<kind::Sphere, kind::Aabb>>("closest_points/sphere_aabb", 8));
  queries.push_back(closest_points_query<Closest<kind::Capsule, kind::Triangle>>(
      "closest_points/capsule_triangle", 16));
}

}  // namespace detent::accuracy
