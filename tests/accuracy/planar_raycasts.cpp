// SPDX-License-Identifier: MIT
#include "accuracy/catalogue.hpp"
#include "accuracy/pair.hpp"
#include "detent/query/raycast.hpp"

namespace detent::accuracy {

void add_planar_raycasts(std::vector<Query>& queries) {
  queries.push_back(ray_query<Raycast<kind::Sphere, NoBaseline, 2>>("raycast/sphere_2d", 1, false));
  add_raycasts_at<2>(queries, kind::AfterSphere());
}

}  // namespace detent::accuracy
