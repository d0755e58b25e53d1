// SPDX-License-Identifier: MIT
#include "scene/casts.hpp"

using namespace detent;

TEST_CASE("scene: casts find what a list of its objects finds, after any history") {
  using S = q16_16;
  test::live_and_cast<S, 3, Sphere<S, 3>, Obb<S, 3>>(11, 60, 150, 6);
}
