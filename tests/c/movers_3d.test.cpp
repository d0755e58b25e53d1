// SPDX-License-Identifier: MIT
#include "movers.hpp"

namespace detent::test_c {

TEST_CASE("C movers: a walk gives the bits of C++, in 3D") { check_walk<3>(); }

}  // namespace detent::test_c
