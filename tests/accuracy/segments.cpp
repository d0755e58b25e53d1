// SPDX-License-Identifier: MIT
#include "accuracy/catalogue.hpp"
#include "accuracy/pair.hpp"
#include "detent/query/intersects.hpp"

namespace detent::accuracy {

void add_segments(std::vector<Query>& queries) {
  add_segments_at<3>(queries, kind::Solids());
  add_segments_at<3>(queries, kind::List<kind::Hull>());
}

}  // namespace detent::accuracy
