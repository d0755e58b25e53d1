// SPDX-License-Identifier: MIT
#include "accuracy/catalogue.hpp"
#include "accuracy/pair.hpp"
#include "detent/query/overlaps.hpp"

namespace detent::accuracy {

void add_planar_hull_overlaps(std::vector<Query>& queries) {
  add_overlaps_with<2, kind::Hull>(queries, kind::Solids());
  add_overlap<2, kind::Hull, kind::Hull>(queries);
}

}  // namespace detent::accuracy
