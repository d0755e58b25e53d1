// SPDX-License-Identifier: MIT
#include "query/distance/kinds.hpp"

namespace detent::test {

TEMPLATE_TEST_CASE("distance of two shapes: every two kinds of shapes in 3D", "[distance]",
                   DETENT_EVERY_SCALAR) {
  check_distances<TestType, 3>();
}

}  // namespace detent::test
