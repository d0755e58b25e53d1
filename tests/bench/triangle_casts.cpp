// SPDX-License-Identifier: MIT
#include "bench/pairs.hpp"
#include "bench/suite.hpp"

void detent::bench::add_triangle_casts(Suite& suite) {
  visit_triangle_casts([&](const auto& query) { suite.add_pair(query); });
}
