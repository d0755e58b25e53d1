// SPDX-License-Identifier: MIT
#include "small/grids.hpp"

using namespace detent;
using namespace detent::small;

TEST_CASE("small worlds: 31 bits, one of them integral", "[small]") {
  ask_all<Fixed<31, 30>, 3>(225'000, 48'000, 90'000);
}

TEST_CASE("small worlds: 31 bits, all of them integral", "[small]") {
  ask_all<Fixed<31, 0>, 2>(40'625, 48'000, 90'000);
}
