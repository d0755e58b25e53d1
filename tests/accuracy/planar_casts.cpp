// SPDX-License-Identifier: MIT
#include "accuracy/catalogue.hpp"
#include "accuracy/pair.hpp"
#include "accuracy/pair_cast.hpp"

namespace detent::accuracy {

void add_planar_casts(std::vector<Query>& queries) {
  queries.push_back(cast_query<Casting<kind::Obb, kind::Obb, 2>>("cast/obb_obb_2d", 40));
}

}  // namespace detent::accuracy
