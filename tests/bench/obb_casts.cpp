// SPDX-License-Identifier: MIT
#include "bench/pairs.hpp"
#include "bench/suite.hpp"

void detent::bench::add_obb_casts(Suite& suite) {
  visit_obb_casts([&](const auto& query) { suite.add_pair(query); });
}
