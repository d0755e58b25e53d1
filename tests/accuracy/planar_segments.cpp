// SPDX-License-Identifier: MIT
#include "accuracy/catalogue.hpp"
#include "accuracy/pair.hpp"
#include "detent/query/intersects.hpp"

namespace detent::accuracy {

void add_planar_segments(std::vector<Query>& queries) {
  add_segments_at<2>(queries, kind::Solids());
  add_segments_at<2>(queries, kind::List<kind::Hull, kind::Segment>());
}

}  // namespace detent::accuracy
