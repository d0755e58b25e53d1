// SPDX-License-Identifier: MIT
#include "accuracy/catalogue.hpp"
#include "accuracy/pair.hpp"
#include "detent/query/intersects/aabb.hpp"
#include "detent/query/intersects/capsule.hpp"
#include "detent/query/intersects/hull.hpp"
#include "detent/query/intersects/obb.hpp"
#include "detent/query/intersects/plane.hpp"
#include "detent/query/intersects/sphere.hpp"
#include "detent/query/intersects/triangle.hpp"

namespace detent::accuracy {

void add_segments(std::vector<Query>& queries) {
  queries.push_back(segment_query<Overlap<kind::Segment, kind::Sphere>>("intersects/sphere", 2));
  queries.push_back(segment_query<Overlap<kind::Segment, kind::Aabb>>("intersects/aabb", 8));
  queries.push_back(segment_query<Overlap<kind::Segment, kind::Obb>>("intersects/obb", 2));
  queries.push_back(segment_query<Overlap<kind::Segment, kind::Plane>>("intersects/plane", 2));
  queries.push_back(
      segment_query<Overlap<kind::Segment, kind::Triangle>>("intersects/triangle", 8));
  queries.push_back(segment_query<Overlap<kind::Segment, kind::Capsule>>("intersects/capsule", 2));
  queries.push_back(segment_query<Overlap<kind::Segment, kind::Hull>>("intersects/hull", 8));
}

}  // namespace detent::accuracy
