// SPDX-License-Identifier: MIT
#include "movers.hpp"

namespace detent::test_c {

TEST_CASE("C movers: a walk gives the bits of C++, in 3D") { check_walk(person<3>()); }
#ifdef DETENT_TEST_EVERY_CAST  // it would compile for half a minute
TEST_CASE("C movers: a walking box gives the bits of C++, in 3D") { check_walk(crate<3>()); }
#endif

}  // namespace detent::test_c
