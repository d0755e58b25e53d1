// SPDX-License-Identifier: MIT
#include "query/closest_points/kinds.hpp"

namespace detent::test {

TEST_CASE("closest points: of every two kinds of shapes, q8_8 in 2D", "[closest_points]") {
  check_closest_points<q8_8, 2>();
}

}  // namespace detent::test
