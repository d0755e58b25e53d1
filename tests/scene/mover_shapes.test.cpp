// SPDX-License-Identifier: MIT
#include "scene/mover_arena.hpp"

namespace detent::test {

TEST_CASE("mover property: a box never ends in a new overlap") {
  explore_all<q16_16, Aabb>(100, 60);
}

}  // namespace detent::test
