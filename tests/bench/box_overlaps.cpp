// SPDX-License-Identifier: MIT
#include "bench/suite.hpp"

void detent::bench::add_box_overlaps(Suite& suite) {
  visit_box_overlaps([&](const auto& query) { suite(query); });
}
