// SPDX-License-Identifier: MIT
#include "accuracy/catalogue.hpp"
#include "accuracy/pair.hpp"
#include "detent/query/overlaps.hpp"

namespace detent::accuracy {

void add_sphere_overlaps(std::vector<Query>& queries) {
  add_overlaps_from<3, kind::Sphere>(queries);
  add_overlap<3, kind::Sphere, kind::Hull>(queries);
}

}  // namespace detent::accuracy
