// SPDX-License-Identifier: MIT
#include "bench/suite.hpp"

void detent::bench::add_hulls(Suite& suite) {
  visit_hulls([&](const auto& query) { suite(query); });
}
