// SPDX-License-Identifier: MIT
// Bodies with numbers from their whole range: assertions hold, and worlds stay valid.
#include "detent/dynamics/dynamics.hpp"

#include "dynamics/draw.hpp"
#include "dynamics/stage.hpp"
#include "oracle/space.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

template <Scalar S, int N>
void add_any(World<S, N, Sphere, Obb, Capsule, Aabb>& world, Random& random) {
  const Numbers<S, N> number{random, random.one_in(4)};
  BodyOptions<S, N> options;
  if (random.one_in(4)) {
    options.motion = random.coin() ? BodyMotion::fixed : BodyMotion::kinematic;
  }
  if (random.one_in(3)) {
    options.density = number.any();
    options.friction = number.any();
    options.restitution = number.any();
    options.linear_damping = number.any();
    options.angular_damping = number.any();
  }
  options.is_fast = world.size() % 3 == 0;
  options.velocity = number.point();
  for (auto& w : options.angular_velocity) w = number();
  switch (random.below(4)) {
    case 0:
      (void)world.add(Sphere<S, N>{number.point(), number.size()}, options);
      break;
    case 1: {
      Obb<S, N> box{number.point(), {}, {}};
      for (int i = 0; i < N; ++i) box.half_extents[i] = number.size();
      const auto angle = Angle<S>::turn(static_cast<int>(random.below(1000)), 1000);
      if constexpr (N == 2) {
        box.rotation = Rotation<S, 2>::from_angle(angle);
      } else {
        box.rotation = Rotation<S, 3>::from_euler(angle, angle, angle);
      }
      (void)world.add(box, options);
      break;
    }
    case 2:
      (void)world.add(Capsule<S, N>{number.point(), number.point(), number.size()}, options);
      break;
    default:
      (void)world.add(Aabb<S, N>{number.point(), number.point()}, options);
      break;
  }
}

}  // namespace

TEMPLATE_TEST_CASE("extremes: bodies with any numbers step without harm", "", DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  Random random(20261123);
  CAPTURE(random.seed());
  const Numbers<S, N> number{random, true};
  std::size_t contacts = 0;
  for (int round = 0; round < 100; ++round) {
    CAPTURE(round);
    WorldSettings<S, N> settings;
    if (round % 4 == 0) {
      settings.gravity = number.point();
      settings.margin = number();
      settings.push_speed = number();
      settings.bounce_threshold = number();
      settings.sleep_speed = number();
    }
    World<S, N, Sphere, Obb, Capsule, Aabb> world(settings);
    for (int i = 0; i < 20; ++i) add_any<S, N>(world, random);
    for (int t = 0; t < 6; ++t) world.step();
    contacts += detail::WorldAccess::contacts(world).size();
    const auto& bodies = detail::WorldAccess::bodies(world);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      REQUIRE(is_unit(to_array(bodies[i].state.orientation)));
    }
  }
  CHECK(contacts > 1000);
}

}  // namespace detent::test
