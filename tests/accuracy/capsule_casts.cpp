// SPDX-License-Identifier: MIT
#include "accuracy/catalogue.hpp"
#include "accuracy/pair.hpp"
#include "accuracy/pair_cast.hpp"

namespace detent::accuracy {

void add_capsule_casts(std::vector<Query>& queries) {
  queries.push_back(
      cast_query<Casting<kind::Capsule, kind::Triangle>>("cast/capsule_triangle", 16));
}

}  // namespace detent::accuracy
