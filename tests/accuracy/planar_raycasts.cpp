// SPDX-License-Identifier: MIT
#include "accuracy/catalogue.hpp"
#include "accuracy/pair.hpp"
#include "detent/query/raycast.hpp"
#include "detent/query/raycast/capsule.hpp"
#include "detent/query/raycast/hull.hpp"

namespace detent::accuracy {

void add_planar_raycasts(std::vector<Query>& queries) {
  queries.push_back(ray_query<Raycast<kind::Sphere, NoBaseline, 2>>("raycast/sphere_2d", 1, false));
  queries.push_back(ray_query<Raycast<kind::Aabb, NoBaseline, 2>>("raycast/aabb_2d", 1));
  queries.push_back(ray_query<Raycast<kind::Obb, NoBaseline, 2>>("raycast/obb_2d", 1));
  queries.push_back(ray_query<Raycast<kind::Plane, NoBaseline, 2>>("raycast/plane_2d", 1));
  queries.push_back(ray_query<Raycast<kind::Triangle, NoBaseline, 2>>("raycast/triangle_2d", 1));
  queries.push_back(ray_query<Raycast<kind::Capsule, NoBaseline, 2>>("raycast/capsule_2d", 4));
  queries.push_back(ray_query<Raycast<kind::Hull, NoBaseline, 2>>("raycast/hull_2d", 8));
}

}  // namespace detent::accuracy
