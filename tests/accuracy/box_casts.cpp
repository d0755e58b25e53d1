// SPDX-License-Identifier: MIT
#include "accuracy/catalogue.hpp"
#include "accuracy/pair.hpp"
#include "accuracy/pair_cast.hpp"

namespace detent::accuracy {

void add_box_casts(std::vector<Query>& queries) {
  queries.push_back(cast_query<Casting<kind::Obb, kind::Obb>>("cast/obb_obb", 80));
}

}  // namespace detent::accuracy
