// SPDX-License-Identifier: MIT
#include "accuracy/catalogue.hpp"
#include "accuracy/pair.hpp"
#include "detent/query/overlaps.hpp"

namespace detent::accuracy {

void add_box_overlaps(std::vector<Query>& queries) {
  add_overlaps_from<3, kind::Aabb>(queries);
  add_overlaps_from<3, kind::Obb>(queries);
}

}  // namespace detent::accuracy
