// SPDX-License-Identifier: MIT
#include "accuracy/catalogue.hpp"
#include "accuracy/pair.hpp"
#include "accuracy/pair_points.hpp"

namespace detent::accuracy {

void add_flat_closest_points(std::vector<Query>& queries) {
  queries.push_back(
      closest_points_query<Closest<kind::Obb, kind::Obb>>("closest_points/obb_obb", 40));
  queries.push_back(
      closest_points_query<Closest<kind::Hull, kind::Hull>>("closest_points/hull_hull", 40));
}

}  // namespace detent::accuracy
