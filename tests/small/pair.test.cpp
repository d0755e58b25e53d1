// SPDX-License-Identifier: MIT
#include "small/pairs.hpp"

using namespace detent;
using namespace detent::small;

TEST_CASE("small worlds: pairs in a 2D world of 16 points", "[small]") {
  ask_every_pair<Fixed<1, 0>, 2>(400, 2'935'552);
}

TEST_CASE("small worlds: pairs in a 2D world of 64 points", "[small]") {
  ask_every_pair<Fixed<2, 1>, 2>(400, 4'953'600);
}

TEST_CASE("small worlds: pairs in a 3D world of 64 points", "[small]") {
  ask_every_pair<Fixed<1, 0>, 3>(250, 2'250'000);
}

TEST_CASE("small worlds: pairs in a 2D world of 16 points, more", "[small][.demand]") {
  ask_every_pair<Fixed<1, 0>, 2>(2'000, 36'086'272);
}

TEST_CASE("small worlds: pairs in a 2D world of 64 points, more", "[small][.demand]") {
  ask_every_pair<Fixed<2, 1>, 2>(1'500, 53'667'664);
}

TEST_CASE("small worlds: pairs in a 3D world of 64 points, more", "[small][.demand]") {
  ask_every_pair<Fixed<1, 0>, 3>(800, 16'963'648);
}
