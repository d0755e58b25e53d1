// SPDX-License-Identifier: MIT
#include "casts.hpp"

namespace detent::test_c {

TEST_CASE("C casts: the bits are those of C++ in 2D") {
  Share hits;
  check_pairs<2>(21, 200, [&](const auto& a, const auto& b, const auto& way) {
    check_cast<2>(a, b, way, hits);
  });
  hits.check();
}

}  // namespace detent::test_c
