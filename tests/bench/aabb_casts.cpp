// SPDX-License-Identifier: MIT
#include "bench/pairs.hpp"
#include "bench/suite.hpp"

void detent::bench::add_aabb_casts(Suite& suite) {
  visit_aabb_casts([&](const auto& query) { suite.add_pair(query); });
}
