// SPDX-License-Identifier: MIT
//
// Prints the name of each query, a line each.

#include <cstdio>
#include <string>

#include "size/queries.hpp"

int main() {
  const auto print = [](const auto& query) { std::puts(std::string(query.name).c_str()); };
  detent::size::visit_raycasts(print);
  detent::size::visit_spheres(print);
  detent::size::visit_boxes(print);
  detent::size::visit_others(print);
  detent::size::visit_distances(print);
  detent::size::visit_closest_points(print);
  detent::size::visit_contacts(print);
  detent::size::visit_casts(print);
}
