// SPDX-License-Identifier: MIT
#include "scene/mover_arena.hpp"

namespace detent::test {

TEST_CASE("mover property: never ends in a new overlap") { explore_all<q16_16, Capsule>(200, 60); }

TEST_CASE("mover property: never ends in a new overlap in ten million moves", "[.demand]") {
  explore_all<q16_16, Capsule>(100000, 100);
}

}  // namespace detent::test
