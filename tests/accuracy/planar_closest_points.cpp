// SPDX-License-Identifier: MIT
#include "accuracy/catalogue.hpp"
#include "accuracy/pair.hpp"
#include "accuracy/pair_points.hpp"

namespace detent::accuracy {

void add_planar_closest_points(std::vector<Query>& queries) {
  queries.push_back(
      closest_points_query<Closest<kind::Obb, kind::Obb, 2>>("closest_points/obb_obb_2d", 16));
}

}  // namespace detent::accuracy
