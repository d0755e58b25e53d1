// SPDX-License-Identifier: MIT
#include "unions.hpp"

namespace detent::test_c {

TEST_CASE("C lists of shapes: the bits are those of C++, in 2D") { check_unions<2>(22, 200); }

}  // namespace detent::test_c
