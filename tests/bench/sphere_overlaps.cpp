// SPDX-License-Identifier: MIT
#include "bench/suite.hpp"

void detent::bench::add_sphere_overlaps(Suite& suite) {
  visit_sphere_overlaps([&](const auto& query) { suite(query); });
}
