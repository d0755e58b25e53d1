// SPDX-License-Identifier: MIT
#include "bench/pairs.hpp"
#include "bench/suite.hpp"

void detent::bench::add_round_closest_points(Suite& suite) {
  visit_round_closest_points([&](const auto& query) { suite.add_pair(query); });
}
