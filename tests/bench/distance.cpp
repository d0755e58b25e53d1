// SPDX-License-Identifier: MIT
#include "bench/suite.hpp"

void detent::bench::add_distances(Suite& suite) {
  visit_distances([&](const auto& query) { suite(query); });
}
