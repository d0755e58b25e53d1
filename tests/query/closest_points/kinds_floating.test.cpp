// SPDX-License-Identifier: MIT
#include "query/closest_points/kinds.hpp"

namespace detent::test {

TEST_CASE("closest points: of every two kinds of shapes, float in 3D", "[closest_points]") {
  check_closest_points<float, 3>();
}

}  // namespace detent::test
