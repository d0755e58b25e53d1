// SPDX-License-Identifier: MIT
#include <vector>

#include "detent/dynamics/world.hpp"
#include "dynamics/draw.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

using S = q16_16;

/// Hulls of any size among boxes, balls and capsules: assertions hold, and positions stay in range.
template <int N>
void step_anything(Random& random, std::size_t& contacts) {
  std::vector<std::vector<Vec<S, N>>> points(4);
  std::vector<SolidHull<S, N>> solids;
  for (auto& set : points) {
    const Numbers<S, N> number{random, random.coin()};
    for (auto i = random.between(4, 32); i > 0; --i) set.push_back(number.point());
    if (const auto solid = solid_hull(1, ConvexHull<S, N>{set})) solids.push_back(*solid);
  }
  World<S, N, Capsule, Obb, BodyHull> world;
  for (int i = 0; i < 16; ++i) {
    const Numbers<S, N> number{random, random.one_in(3)};
    BodyOptions<S, N> options;
    if (random.one_in(4)) options.motion = BodyMotion::fixed;
    options.is_fast = i % 3 == 0;
    options.velocity = number.point();
    for (auto& w : options.angular_velocity) w = number();
    const auto angle = Angle<S>::turn(static_cast<int>(random.below(1000)), 1000);
    Rotation<S, N> rotation;
    if constexpr (N == 2) {
      rotation = Rotation<S, 2>::from_angle(angle);
    } else {
      rotation = Rotation<S, 3>::from_euler(angle, angle, angle);
    }
    switch (random.below(5)) {
      case 0:
        (void)world.add(Capsule<S, N>{number.point(), number.point(), number()}, options);
        break;
      case 1:
        (void)world.add(Obb<S, N>{number.point(), number.point(), rotation}, options);
        break;
      default:
        if (solids.empty()) break;
        (void)world.add(
            BodyHull<S, N>{&solids[random.below(solids.size())], number.point(), rotation},
            options);
    }
  }
  for (int t = 0; t < 4; ++t) world.step();
  contacts += detail::WorldAccess::contacts(world).size();
  const auto& bodies = detail::WorldAccess::bodies(world);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    REQUIRE(is_unit(to_array(bodies[i].state.orientation)));
  }
}

TEST_CASE("hull body: hulls with any numbers step without harm") {
  Random random(32);
  CAPTURE(random.seed());
  std::size_t contacts = 0;
  for (int round = 0; round < 60; ++round) {
    step_anything<2>(random, contacts);
    step_anything<3>(random, contacts);
  }
  CHECK(contacts > 600);
}

}  // namespace
}  // namespace detent::test
