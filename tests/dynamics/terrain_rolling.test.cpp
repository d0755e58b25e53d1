// SPDX-License-Identifier: MIT
#include <type_traits>
#include <vector>

#include "detent/scene/height_field/height_field.hpp"
#include "dynamics/terrain.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

template <Scalar S>
using Slope = World<S, 3, Sphere, Aabb, BodyMesh, BodyHeightField>;

TEMPLATE_TEST_CASE("terrain: a ball rolls over many triangles with the bits of a single face", "",
                   q16_16, q24_8, q14_16) {
  using S = TestType;
  const Owned<S> fine(square<S>(40, 8, level)), coarse(square<S>(1, 8, level));
  std::vector<S> heights(33 * 33);
  const auto field = height_field<S>({num<S>(-8), num<S>(-8)}, num<S>(0.5), 33, 33, heights);
  REQUIRE(field);
  const FieldAsset<S> field_asset(2, *field);
  std::vector<Slope<S>> worlds(4);
  worlds[0].add(Aabb<S, 3>{point<S>(-8, -4, -8), point<S>(8, 0, 8)}, fixed<S>());
  worlds[1].add(BodyMesh<S, 3>{&coarse.asset, point<S>(0, 0, 0), {}}, fixed<S>());
  worlds[2].add(BodyMesh<S, 3>{&fine.asset, point<S>(0, 0, 0), {}}, fixed<S>());
  worlds[3].add(BodyHeightField<S, 3>{&field_asset, point<S>(0, 0, 0)}, fixed<S>());
  BodyOptions<S, 3> rolls;
  rolls.velocity = point<S>(3, -1, 1.7);
  rolls.angular_velocity = {num<S>(1), num<S>(2), num<S>(-4)};
  for (auto& world : worlds) {
    world.add(Sphere<S, 3>{point<S>(-7.13, 0.625, -5.21), num<S>(0.5)}, rolls);
  }
  int begun = 0;
  for (int t = 0; t < 150; ++t) {
    for (auto& world : worlds) world.step();
    for (std::size_t i = 0; i < worlds[2].event_count(); ++i) begun += worlds[2].event(i).begins;
    const auto state = [&](std::size_t i) {
      return detail::WorldAccess::bodies(worlds[i])[1].state;
    };
    for (std::size_t i = 1; i < 4; ++i) REQUIRE(state(i).velocity == state(1).velocity);
    for (std::size_t i = 1; i < 4; ++i) REQUIRE(state(i) == state(1));
    // The box has another center, for which levers are equal in every scalar except q24_8.
    REQUIRE(state(0).place.y == state(1).place.y);
    if (std::is_same_v<S, q16_16>) REQUIRE(state(0) == state(1));
  }
  CHECK(worlds[2].position({1, 2}).x > num<S>(-2));
  CHECK(begun == 1);  // one touch across all triangles
}

}  // namespace
}  // namespace detent::test
