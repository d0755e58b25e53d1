// SPDX-License-Identifier: MIT
//
// The formats of fewer than 31 bits, in a separate source to save memory.

#include "small/grids.hpp"

using namespace detent;
using namespace detent::small;

TEST_CASE("small worlds: 30 bits, one of them integral", "[small]") {
  ask_all<Fixed<30, 29>, 3>(225'000, 48'000, 90'000);
}

TEST_CASE("small worlds: 14 bits, one of them integral", "[small]") {
  ask_all<Fixed<14, 13>, 2>(40'625, 48'000, 90'000);
}
