// SPDX-License-Identifier: MIT
#include "bench/suite.hpp"

void detent::bench::add_closest_points(Suite& suite) {
  visit_closest_points([&](const auto& query) { suite(query); });
}
