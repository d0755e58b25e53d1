// SPDX-License-Identifier: MIT
#include "accuracy/catalogue.hpp"
#include "accuracy/pair.hpp"
#include "detent/query/contact.hpp"

namespace detent::accuracy {

void add_planar_capsule_contacts(std::vector<Query>& queries) {
  queries.push_back(pair_query<Touching<kind::Capsule, kind::Triangle, 2>>(
      "contact", "contact/capsule_triangle_2d", 16));
}

}  // namespace detent::accuracy
