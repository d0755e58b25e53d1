// SPDX-License-Identifier: MIT
#include "bench/pairs.hpp"
#include "bench/suite.hpp"

void detent::bench::add_segment_casts(Suite& suite) {
  visit_segment_casts([&](const auto& query) { suite.add_pair(query); });
}
