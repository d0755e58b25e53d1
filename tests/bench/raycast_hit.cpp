// SPDX-License-Identifier: MIT
#include "bench/suite.hpp"

void detent::bench::add_raycast_hits(Suite& suite) {
  visit_raycast_hits([&](const auto& query) { suite(query); });
}
