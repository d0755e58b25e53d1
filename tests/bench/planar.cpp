// SPDX-License-Identifier: MIT
#include "bench/suite.hpp"

void detent::bench::add_planar(Suite& suite) {
  visit_planar([&](const auto& query) { suite(query); });
}
