// SPDX-License-Identifier: MIT
#include "bench/suite.hpp"

void detent::bench::add_overlaps(Suite& suite) {
  visit_overlaps([&](const auto& query) { suite(query); });
}
