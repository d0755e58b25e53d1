// SPDX-License-Identifier: MIT
#include "small/rays.hpp"

using namespace detent;
using namespace detent::small;

TEST_CASE("small worlds: rays of a 2D world of 16 points", "[small]") {
  ask_every_ray<Fixed<1, 0>, 2>(100'000, 600, 7'041'024);
}

TEST_CASE("small worlds: rays of a 2D world of 64 points", "[small]") {
  ask_every_ray<Fixed<2, 1>, 2>(1'000, 1'000, 6'672'000);
}

TEST_CASE("small worlds: rays of a 3D world of 64 points", "[small]") {
  ask_every_ray<Fixed<1, 0>, 3>(1'000, 1'000, 6'664'000);
}

TEST_CASE("small worlds: rays of a 2D world of 16 points, all shapes", "[small][.demand]") {
  ask_every_ray<Fixed<1, 0>, 2>(100'000, 5'000, 31'548'672);
}

TEST_CASE("small worlds: rays of a 2D world of 64 points, more", "[small][.demand]") {
  ask_every_ray<Fixed<2, 1>, 2>(10'000, 1'500, 96'720'000);
}

TEST_CASE("small worlds: rays of a 3D world of 64 points, more", "[small][.demand]") {
  ask_every_ray<Fixed<1, 0>, 3>(10'000, 1'500, 96'640'000);
}
