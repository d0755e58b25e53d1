// SPDX-License-Identifier: MIT
#include "bench/golden_check.hpp"
#include "bench/pairs.hpp"

using namespace detent::bench;

TEST_CASE("golden: contacts have their hit counts") {
  visit_round_contacts(check_golden);
  visit_flat_contacts(check_golden);
  visit_hull_contacts(check_golden);
}
