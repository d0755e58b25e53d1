// SPDX-License-Identifier: MIT
#include <vector>

#include "detent/dynamics/world.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace detent::test {
namespace {

using S = q16_16;

/// Hulls of any size among boxes, balls and capsules: assertions hold, and positions stay in range.
template <int N>
void step_anything(Random& random, std::size_t& contacts) {
  const auto number = [&](bool wild) {
    return wild ? S::from_raw(static_cast<typename S::raw_type>(random.edgy(S::bits)))
                : quotient_nearest<S>(static_cast<int>(random.between(-1000, 1000)), 250);
  };
  const auto point = [&](bool wild) { return make_vec<N>([&](int) { return number(wild); }); };
  std::vector<std::vector<Vec<S, N>>> points(4);
  std::vector<SolidHull<S, N>> solids;
  for (auto& set : points) {
    const bool wild = random.coin();
    for (auto i = random.between(4, 32); i > 0; --i) set.push_back(point(wild));
    if (const auto solid = solid_hull(1, ConvexHull<S, N>{set})) solids.push_back(*solid);
  }
  World<S, N, Capsule, Obb, BodyHull> world;
  for (int i = 0; i < 16; ++i) {
    const bool wild = random.one_in(3);
    BodyOptions<S, N> options;
    if (random.one_in(4)) options.motion = BodyMotion::fixed;
    options.is_fast = i % 3 == 0;
    options.velocity = point(wild);
    for (auto& w : options.angular_velocity) w = number(wild);
    const auto angle = Angle<S>::turn(static_cast<int>(random.below(1000)), 1000);
    Rotation<S, N> rotation;
    if constexpr (N == 2) {
      rotation = Rotation<S, 2>::from_angle(angle);
    } else {
      rotation = Rotation<S, 3>::from_euler(angle, angle, angle);
    }
    switch (random.below(5)) {
      case 0:
        (void)world.add(Capsule<S, N>{point(wild), point(wild), number(wild)}, options);
        break;
      case 1:
        (void)world.add(Obb<S, N>{point(wild), point(wild), rotation}, options);
        break;
      default:
        if (solids.empty()) break;
        (void)world.add(BodyHull<S, N>{&solids[random.below(solids.size())], point(wild), rotation},
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
