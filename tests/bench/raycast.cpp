// SPDX-License-Identifier: MIT
#include "bench/suite.hpp"

void detent::bench::add_raycasts(Suite& suite) {
  visit_raycasts([&](const auto& query) { suite(query); });
}
