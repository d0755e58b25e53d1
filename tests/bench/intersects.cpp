// SPDX-License-Identifier: MIT
#include "bench/suite.hpp"

void detent::bench::add_intersects(Suite& suite) {
  visit_intersects([&](const auto& query) { suite(query); });
}
