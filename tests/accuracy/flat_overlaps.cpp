// SPDX-License-Identifier: MIT
#include "accuracy/catalogue.hpp"
#include "accuracy/pair.hpp"
#include "detent/query/overlaps.hpp"

namespace detent::accuracy {

void add_flat_overlaps(std::vector<Query>& queries) {
  add_overlaps_after<3, kind::Plane>(queries, kind::Solids());
  add_overlaps_from<3, kind::Triangle>(queries);
}

}  // namespace detent::accuracy
