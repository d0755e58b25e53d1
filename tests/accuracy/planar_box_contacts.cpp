// SPDX-License-Identifier: MIT
#include "accuracy/catalogue.hpp"
#include "accuracy/pair.hpp"
#include "detent/query/contact.hpp"

namespace detent::accuracy {

void add_planar_box_contacts(std::vector<Query>& queries) {
  queries.push_back(
      pair_query<Touching<kind::Obb, kind::Obb, 2>>("contact", "contact/obb_obb_2d", 40));
}

}  // namespace detent::accuracy
