// SPDX-License-Identifier: MIT
#include "bench/golden_check.hpp"
#include "bench/still_pairs.hpp"

using namespace detent::bench;

TEST_CASE("golden: contacts in 3D have their hit counts") {
  visit_pairs<PairQuery::contact, 3>(check_golden);
}
TEST_CASE("golden: contacts in 2D have their hit counts") {
  visit_pairs<PairQuery::contact, 2>(check_golden);
}
