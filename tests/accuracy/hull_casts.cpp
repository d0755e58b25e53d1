// SPDX-License-Identifier: MIT
#include "accuracy/catalogue.hpp"
#include "accuracy/pair.hpp"
#include "accuracy/pair_cast.hpp"

namespace detent::accuracy {

void add_hull_casts(std::vector<Query>& queries) {
  queries.push_back(cast_query<Casting<kind::Hull, kind::Hull>>("cast/hull_hull", 40));
}

}  // namespace detent::accuracy
