// SPDX-License-Identifier: MIT
#include "scene/mover_arena.hpp"

namespace detent::test {

TEST_CASE("mover property: nor does a box") { explore_all<q16_16, Aabb>(100, 60); }

}  // namespace detent::test
