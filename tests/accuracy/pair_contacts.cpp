// SPDX-License-Identifier: MIT
#include "accuracy/catalogue.hpp"
#include "accuracy/pair.hpp"
#include "detent/query/contact.hpp"

namespace detent::accuracy {

void add_pair_contacts(std::vector<Query>& queries) {
  queries.push_back(
      pair_query<Touching<kind::Sphere, kind::Aabb>>("contact", "contact/sphere_aabb", 16));
  queries.push_back(pair_query<Touching<kind::Capsule, kind::Triangle>>(
      "contact", "contact/capsule_triangle", 16));
  queries.push_back(pair_query<Touching<kind::Obb, kind::Obb>>("contact", "contact/obb_obb", 40));
}

}  // namespace detent::accuracy
