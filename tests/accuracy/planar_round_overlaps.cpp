// SPDX-License-Identifier: MIT
#include "accuracy/catalogue.hpp"
#include "accuracy/pair.hpp"
#include "detent/query/overlaps.hpp"

namespace detent::accuracy {

void add_planar_round_overlaps(std::vector<Query>& queries) {
  add_overlaps_from<2, kind::Sphere>(queries);
  using Others = kind::List<kind::Aabb, kind::Obb, kind::Plane, kind::Triangle, kind::Capsule>;
  add_overlaps_with<2, kind::Capsule>(queries, Others());
}

}  // namespace detent::accuracy
