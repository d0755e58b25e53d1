// SPDX-License-Identifier: MIT
#include "scene/mover_arena.hpp"

namespace detent::test {

TEST_CASE("mover property: no step passes through anything it did not start in") {
  using S = q16_16;
  using World = Arena<S>::World;
  int held = 0, cut = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Arena<S> arena(seed);
    const Everything all;
    for (int i = 0; i < 6; ++i) {
      const auto start = arena.character<Sphere>();
      detail::Stepper<S, 3, World, Sphere<S, 3>, Everything> steps(arena.world, all, start,
                                                                   arena.number(arena.unit / 64));
      steps.prepare();
      const auto is_other = [&](const ObjectInfo& object) {
        return !arena.world.any(start, [&](const ObjectInfo& o) { return o.id == object.id; });
      };
      held += steps.is_held();
      for (int j = 0; j < 3; ++j) {
        CAPTURE(seed, i, j);
        const auto before = steps.shape();
        const auto step = steps.look(arena.move());
        steps.go(step.by);
        cut += step.hit.has_value();
        // A step deviates from its straight path by less than an ULP.
        const Capsule<S, 3> way{before.center, steps.shape().center,
                                nearest_to<S>(before.radius - arena.number(1))};
        REQUIRE_FALSE(arena.world.any(way, is_other));
        REQUIRE_FALSE(arena.world.any(steps.shape(), is_other));
      }
    }
  }
  CHECK(held > 100);
  CHECK(cut > 300);
}

}  // namespace detent::test
