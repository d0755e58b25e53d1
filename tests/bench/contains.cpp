// SPDX-License-Identifier: MIT
#include "bench/suite.hpp"

void detent::bench::add_contains(Suite& suite) {
  visit_contains([&](const auto& query) { suite(query); });
}
