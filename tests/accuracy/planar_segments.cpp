// SPDX-License-Identifier: MIT
#include "accuracy/catalogue.hpp"
#include "accuracy/pair.hpp"
#include "detent/query/intersects/aabb.hpp"
#include "detent/query/intersects/capsule.hpp"
#include "detent/query/intersects/hull.hpp"
#include "detent/query/intersects/obb.hpp"
#include "detent/query/intersects/plane.hpp"
#include "detent/query/intersects/segment.hpp"
#include "detent/query/intersects/sphere.hpp"
#include "detent/query/intersects/triangle.hpp"

namespace detent::accuracy {

void add_planar_segments(std::vector<Query>& queries) {
  queries.push_back(
      segment_query<Overlap<kind::Segment, kind::Sphere, 2>>("intersects/sphere_2d", 2));
  queries.push_back(segment_query<Overlap<kind::Segment, kind::Aabb, 2>>("intersects/aabb_2d", 8));
  queries.push_back(segment_query<Overlap<kind::Segment, kind::Obb, 2>>("intersects/obb_2d", 2));
  queries.push_back(
      segment_query<Overlap<kind::Segment, kind::Plane, 2>>("intersects/plane_2d", 2));
  queries.push_back(
      segment_query<Overlap<kind::Segment, kind::Triangle, 2>>("intersects/triangle_2d", 8));
  queries.push_back(
      segment_query<Overlap<kind::Segment, kind::Capsule, 2>>("intersects/capsule_2d", 2));
  queries.push_back(segment_query<Overlap<kind::Segment, kind::Hull, 2>>("intersects/hull_2d", 8));
  queries.push_back(
      segment_query<Overlap<kind::Segment, kind::Segment, 2>>("intersects/segment_2d", 8));
}

}  // namespace detent::accuracy
