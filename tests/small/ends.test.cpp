// SPDX-License-Identifier: MIT
//
// Long scalars: the ends of their range and the numbers about 0, on the finest grid there is.

#include "small/pairs.hpp"
#include "small/points.hpp"
#include "small/rays.hpp"

using namespace detent;
using namespace detent::small;

TEST_CASE("small worlds: points at the ends of 31 bits", "[small]") {
  ask_every_point<Fixed<31, 30>, 2>(400, 0);
  ask_every_point<Fixed<31, 30>, 3>(200, 0);
}

TEST_CASE("small worlds: rays at the ends of 31 bits", "[small]") {
  ask_every_ray<Fixed<31, 30>, 2>(200, 80, 0);
  ask_every_ray<Fixed<31, 30>, 3>(200, 80, 0);
}

TEST_CASE("small worlds: pairs at the ends of 31 bits", "[small]") {
  ask_every_pair<Fixed<31, 30>, 2>(80, 0);
  ask_every_pair<Fixed<31, 30>, 3>(50, 0);
}
