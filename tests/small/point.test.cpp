// SPDX-License-Identifier: MIT
#include "small/points.hpp"

using namespace detent;
using namespace detent::small;

TEST_CASE("small worlds: points of a 2D world of 16 points", "[small]") {
  ask_every_point<Fixed<1, 0>, 2>(100'000, 239'568);
}

TEST_CASE("small worlds: points of a 2D world of 64 points", "[small]") {
  ask_every_point<Fixed<2, 1>, 2>(5'000, 2'157'376);
}

TEST_CASE("small worlds: points of a 3D world of 64 points", "[small]") {
  ask_every_point<Fixed<1, 0>, 3>(3'000, 1'322'624);
}

TEST_CASE("small worlds: points of a 2D world of 64 points, all shapes", "[small][.demand]") {
  ask_every_point<Fixed<2, 1>, 2>(300'000, 23'552'832);
}

TEST_CASE("small worlds: points of a 2D world of 256 points", "[small][.demand]") {
  ask_every_point<Fixed<3, 1>, 2>(10'000, 17'730'816);
}

TEST_CASE("small worlds: points of a 3D world of 64 points, all shapes", "[small][.demand]") {
  ask_every_point<Fixed<1, 0>, 3>(300'000, 24'648'320);
}
