// SPDX-License-Identifier: MIT
#include "bench/suite.hpp"

void detent::bench::add_other_overlaps(Suite& suite) {
  visit_other_overlaps([&](const auto& query) { suite(query); });
}
