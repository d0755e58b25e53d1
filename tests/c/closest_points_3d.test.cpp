// SPDX-License-Identifier: MIT
#include "casts.hpp"

namespace detent::test_c {

TEST_CASE("C closest points: the bits are those of C++ in 3D") {
  check_pairs<3>(31, 200,
                 [](const auto& a, const auto& b, const auto&) { check_closest_points<3>(a, b); });
}

}  // namespace detent::test_c
