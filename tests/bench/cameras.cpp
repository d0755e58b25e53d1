// SPDX-License-Identifier: MIT
#include "bench/suite.hpp"

void detent::bench::add_cameras(Suite& suite) {
  visit_cameras([&](const auto& query) { suite(query); });
}
