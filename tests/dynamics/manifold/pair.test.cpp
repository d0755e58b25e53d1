// SPDX-License-Identifier: MIT
#include "detent/dynamics/manifold/pair.hpp"

#include "dynamics/manifold/helpers.hpp"

namespace detent::test {
namespace {

TEMPLATE_TEST_CASE("manifold: the contact of two balls is midway between them", "[manifold]",
                   q16_16, q24_8, q8_8, double) {
  using S = TestType;
  const Sphere<S, 3> ball{{}, num<S>(1)};
  const auto m = manifold(ball, ball, shifted<S, 3>(0, 0, 2), gap<S>(0));
  REQUIRE(m.count == 1);
  CHECK(m.normal == detail::unit_axis<ratio<S>, 3>(2));
  CHECK(m.points[0].separation == 0);
  CHECK(m.points[0].point == levers<S, 3>(0, 0, 1));
  CHECK(manifold(ball, ball, shifted<S, 3>(0, 0, 3), gap<S>(0)).count == 0);
  CHECK(manifold(ball, ball, shifted<S, 3>(0, 0, 3), gap<S>(1)).count == 1);
  // Concentric, one inside the other: the normal is the x axis.
  const auto deep = manifold(ball, ball, shifted<S, 3>(0, 0, 0), gap<S>(0));
  REQUIRE(deep.count == 1);
  CHECK(deep.normal == detail::unit_axis<ratio<S>, 3>(0));
  CHECK(deep.points[0].separation == -2);
}

TEMPLATE_TEST_CASE("manifold: two boxes have four contact points, two in 2D", "[manifold]", q16_16,
                   q24_8, q8_8, double) {
  using S = TestType;
  const Obb<S, 3> box{{}, at<S, 3>(1, 1, 1), {}};
  const auto m = manifold(box, box, shifted<S, 3>(0.5, 0, 2), gap<S>(0));
  REQUIRE(m.count == 4);
  CHECK(m.normal == detail::unit_axis<ratio<S>, 3>(2));
  for (const auto& p : m.points) {
    CHECK(p.separation == 0);
    CHECK(p.point.z == 1);
    CHECK(abs(p.point.y) == 1);
  }
  const Aabb<S, 2> flat{at<S, 2>(-1, -1), at<S, 2>(1, 1)};
  const auto two = manifold(flat, flat, shifted<S, 2>(0.5, -2), gap<S>(0));
  REQUIRE(two.count == 2);
  CHECK(two.normal == detail::unit_axis<ratio<S>, 2>(1, true));
  CHECK(two.points[0].point.y == -1);
  CHECK(two.points[0].feature != two.points[1].feature);
}

TEMPLATE_TEST_CASE("manifold: capsules side by side, and a capsule on a box, have two points",
                   "[manifold]", q16_16, q24_8, q8_8, double) {
  using S = TestType;
  const Capsule<S, 3> log{at<S, 3>(-2, 0, 0), at<S, 3>(2, 0, 0), num<S>(0.5)};
  const auto beside = manifold(log, log, shifted<S, 3>(1, 1, 0), gap<S>(0));
  REQUIRE(beside.count == 2);
  CHECK(beside.normal == detail::unit_axis<ratio<S>, 3>(1));
  CHECK(beside.points[0].point == levers<S, 3>(-1, 0.5, 0));
  CHECK(beside.points[1].point == levers<S, 3>(2, 0.5, 0));
  const Obb<S, 3> ground{{}, at<S, 3>(8, 8, 1), {}};
  const auto on_ground = manifold(ground, log, shifted<S, 3>(1, 1, 1.5), gap<S>(0));
  REQUIRE(on_ground.count == 2);
  CHECK(on_ground.normal == detail::unit_axis<ratio<S>, 3>(2));
  CHECK(on_ground.points[0].point == levers<S, 3>(-1, 1, 1));
  const auto under = manifold(log, ground, shifted<S, 3>(1, 1, -1.5), gap<S>(0));
  REQUIRE(under.count == 2);
  CHECK(under.normal == detail::unit_axis<ratio<S>, 3>(2, true));
  CHECK(under.points[1].point == levers<S, 3>(2, 0, -0.5));
}

TEMPLATE_TEST_CASE("manifold: empty shapes touch nothing", "[manifold]", q16_16, float) {
  using S = TestType;
  const Sphere<S, 3> none{{}, num<S>(-1)}, ball{{}, num<S>(1)};
  const Obb<S, 3> no_box{{}, at<S, 3>(1, -1, 1), {}}, box{{}, at<S, 3>(1, 1, 1), {}};
  const auto pose = shifted<S, 3>(0, 0, 0);
  CHECK(manifold(none, ball, pose, gap<S>(1)).count == 0);
  CHECK(manifold(ball, none, pose, gap<S>(1)).count == 0);
  CHECK(manifold(box, none, pose, gap<S>(1)).count == 0);
  CHECK(manifold(none, box, pose, gap<S>(1)).count == 0);
  CHECK(manifold(no_box, ball, pose, gap<S>(1)).count == 0);
  CHECK(manifold(box, no_box, pose, gap<S>(1)).count == 0);
}

static_assert(manifold(Sphere<q16_16, 2>{{}, q16_16(1)}, Aabb<q16_16, 2>{{}, {}},
                       shifted<q16_16, 2>(0, 0), gap<q16_16>(0))
                  .count == 1);

}  // namespace
}  // namespace detent::test
