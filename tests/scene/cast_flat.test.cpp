// SPDX-License-Identifier: MIT
#include "scene/casts.hpp"

using namespace detent;

TEST_CASE("scene: casts find what a list of its objects finds, in 2D and in 16 bits") {
  using S = q8_8;
  test::live_and_cast<S, 2, Capsule<S, 2>, Aabb<S, 2>, Triangle<S, 2>>(12, 60, 150, 6);
}
