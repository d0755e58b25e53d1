// SPDX-License-Identifier: MIT
#include "query/cast/shapes.hpp"

namespace detent::test {
namespace {

TEMPLATE_TEST_CASE("cast: a sphere or capsule against every kind of shape", "[cast]",
                   (Space<q16_16, 3>)) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  visit_round<S, N>(-3, [](const auto& shape) { check_casts<S, N>(shape); });
}

TEST_CASE("cast: a sphere touches the face, edge or corner of a box", "[cast]") {
  using S = q16_16;
  const Aabb<S, 3> box{at<S, 3>(5, -1, -1), at<S, 3>(7, 1, 1)};
  const auto right = toward<S, 3>(1);
  const auto at_height = [&](double y, double z) {
    return cast(Sphere<S, 3>{at<S, 3>(0, y, z), num<S>(5)}, right, num<S>(9), box);
  };
  const auto face = at_height(1, -1);
  REQUIRE(face);
  CHECK(face->distance == S(0));  // touches at the start
  const auto near_face =
      cast(Sphere<S, 3>{at<S, 3>(-3, 0.5, -0.5), num<S>(5)}, right, num<S>(9), box);
  REQUIRE(near_face);
  CHECK(*near_face == CastHit<S, 3>{num<S>(3), at<S, 3>(5, 0.5, -0.5), -right});
  // 3, 4, 5 from the edge at y = 1.
  const auto edge = at_height(4 + 1, 0);
  REQUIRE(edge);
  CHECK(edge->distance == num<S>(2));
  CHECK(edge->point.y == num<S>(1));
  CHECK(edge->normal == toward<S, 3>(-3, 4));
  // At a distance of exactly 5 it touches the box; a step farther away it misses.
  const auto graze = at_height(6, 0);
  REQUIRE(graze);
  CHECK(graze->distance == num<S>(5));
  CHECK(graze->normal == toward<S, 3>(0, 1));
  const auto pass = Sphere<S, 3>{{S(0), moved(num<S>(6), 1), S(0)}, num<S>(5)};
  CHECK_FALSE(cast(pass, right, num<S>(9), box));
}

}  // namespace
}  // namespace detent::test
