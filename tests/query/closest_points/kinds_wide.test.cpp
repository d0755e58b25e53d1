// SPDX-License-Identifier: MIT
#include "query/closest_points/kinds.hpp"

namespace detent::test {

TEST_CASE("closest points: of every two kinds of shapes, q16_16 in 3D", "[closest_points]") {
  check_closest_points<q16_16, 3>();
}

}  // namespace detent::test
