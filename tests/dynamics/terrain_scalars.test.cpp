// SPDX-License-Identifier: MIT
#include "dynamics/terrain.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

template <Scalar S>
using Table = World<S, 3, Sphere, Obb, BodyMesh>;

TEMPLATE_TEST_CASE("terrain: works in every scalar", "", q8_8, float, double) {
  using S = TestType;
  const Owned<S> flat(square<S>(10, 5, level));
  Table<S> world;
  world.add(BodyMesh<S, 3>{&flat.asset, {}, {}}, fixed<S>());
  const auto ball = world.add(Sphere<S, 3>{point<S>(0.25, 1, 0.25), num<S>(0.5)});
  const auto box = world.add(Obb<S, 3>{point<S>(2.25, 1, 0.25), point<S>(0.5, 0.5, 0.5), {}});
  for (int t = 0; t < 60; ++t) world.step();
  CHECK(abs(world.position(*ball).y - num<S>(0.5)) <= num<S>(0.05));
  CHECK(abs(world.position(*box).y - num<S>(0.5)) <= num<S>(0.05));
}

}  // namespace
}  // namespace detent::test
